package org.evoloop.mqtt.home;

import static java.util.Objects.requireNonNull;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.tuple;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;
import org.evoloop.Machines;
import org.evoloop.evolution.ModelPair;
import org.evoloop.mqtt.home.HomeTable.Deed;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** What each command of each kind does in each state, and that it is never something else. */
class HomeTableTest {
    /** Opened and closed by one button, as many garage doors are. */
    private static final StateMachine GARAGE = Machines.machine(
            "garage",
            "Closed button -> Opening",
            "Opening button -> Stopped",
            "Opening isOpened -> Open",
            "Stopped button -> Closing",
            "Open button -> Closing",
            "Closing button -> Between",
            "Closing isClosed -> Closed",
            "Between button -> Opening");

    private static final Map<HomeKind, StateMachine> MODELS = Map.ofEntries(
            Map.entry(HomeKind.COVER, GARAGE),
            Map.entry(HomeKind.VALVE, Machines.machine("valve", "Closed turn -> Open", "Open turn -> Closed")),
            Map.entry(
                    HomeKind.CLIMATE,
                    Machines.machine(
                            "ac",
                            "Off power -> Cool",
                            "Cool power -> Off",
                            "Cool mode -> Dry",
                            "Dry mode -> Cool",
                            "Dry power -> Off",
                            "Cool boost -> Boost",
                            "Boost boost -> Cool",
                            "Boost power -> Off")),
            Map.entry(
                    HomeKind.LIGHT,
                    Machines.machine("light", "Off press -> On", "On press -> Warm", "Warm press -> Off")),
            Map.entry(HomeKind.SWITCH, Machines.machine("plug", "Off press -> On", "On press -> Off")),
            Map.entry(
                    HomeKind.FAN,
                    Machines.machine(
                            "fan", "Off power -> Low", "Low power -> Off", "Low speed -> High", "High power -> Off")),
            Map.entry(
                    HomeKind.HUMIDIFIER,
                    Machines.machine("mist", "Off press -> On", "On press -> Night", "Night press -> Off")),
            Map.entry(
                    HomeKind.LOCK,
                    Machines.machine(
                            "lock",
                            "Locked turn -> Unlocking",
                            "Unlocking isDone -> Unlocked",
                            "Unlocked turn -> Locking",
                            "Locking isDone -> Locked",
                            "Unlocked pull -> Open",
                            "Open pull -> Unlocked")),
            Map.entry(
                    HomeKind.VACUUM,
                    Machines.machine(
                            "vacuum",
                            "Docked clean -> Cleaning",
                            "Cleaning clean -> Paused",
                            "Paused clean -> Cleaning",
                            "Paused dock -> Returning",
                            "Cleaning dock -> Returning",
                            "Returning clean -> Idle",
                            "Idle clean -> Cleaning",
                            "Returning isDocked -> Docked",
                            "Idle spot -> Spot",
                            "Spot clean -> Idle")),
            Map.entry(
                    HomeKind.SELECT, Machines.machine("levels", "One up -> Two", "Two up -> Three", "Three up -> One")),
            Map.entry(HomeKind.BUTTON, Machines.machine("air", "Idle air -> Airing", "Airing air -> Idle")),
            Map.entry(HomeKind.EVENT, Machines.machine("wash", "Idle go -> Done", "Done open -> Idle")));

    private static HomeEntity entity(HomeKind kind) {
        HomeEntity entity = HomeEntity.of(kind);
        return switch (kind) {
            case CLIMATE -> entity.show("Boost", "cool").mode("boost", "Boost");
            case LIGHT -> entity.mode("warm", "Warm");
            case FAN -> entity.mode("fast", "High");
            case HUMIDIFIER -> entity.mode("night", "Night");
            case VACUUM -> entity.command("clean_spot", "Spot");
            case SELECT -> entity.mode("one", "One").mode("two", "Two").mode("three", "Three");
            case BUTTON -> entity.command("press", "Airing");
            case EVENT -> entity.mode("done", "Done");
            default -> entity;
        };
    }

    private static StateMachine model(HomeKind kind) {
        return requireNonNull(MODELS.get(kind));
    }

    private static HomeTable table(HomeEntity entity, StateMachine model) {
        Set<String> events = new LinkedHashSet<>();
        model.triggers().stream()
                .filter(event -> !event.name().startsWith("is"))
                .forEach(event -> events.add(event.name()));
        return HomeTable.of(entity, new ModelPair(model, model), events);
    }

    static Stream<HomeKind> kinds() {
        return Stream.of(HomeKind.values());
    }

    /** The table is believed only as far as walking through the model shows the same. */
    @ParameterizedTest
    @MethodSource("kinds")
    void aCommandDoesInEveryStateWhatItsNameSaysOrNothing(HomeKind kind) {
        StateMachine model = model(kind);
        HomeTable table = table(entity(kind), model);
        assertThat(table.mistakes()).isEmpty();
        for (HomeTable.Row row : table.rows()) {
            List<State> walked = walk(table, model, row);
            if (row.deed() != Deed.ACTS) {
                assertThat(walked).as(row.toString()).hasSize(1);
                continue;
            }
            State end = walked.get(walked.size() - 1);
            HomeKind.Command command = kind.command(row.command());
            if (command == null) {
                assertThat(kind.modeWord() + " " + (table.mode(end).isEmpty() ? "none" : table.mode(end)))
                        .isEqualTo(row.command());
            } else if (!command.ends().isEmpty()) {
                assertThat(command.ends()).as(row.toString()).contains(table.shown(end));
            }
        }
    }

    /** Follows an errand through the model, as the converter would. */
    private static List<State> walk(HomeTable table, StateMachine model, HomeTable.Row row) {
        List<State> walked = new ArrayList<>(List.of(new State(row.state())));
        HomeTable.Decision decided = table.decide(walked.get(0), row.command(), row.shown());
        Way way = decided.way();
        if (way == null) {
            return walked;
        }
        List<String> pressed = new ArrayList<>();
        Errand errand = new Errand(way, decided.goals(), pressed::add, 0);
        State now = walked.get(0);
        for (int seen = 0; errand.step(now, 0) && seen < pressed.size(); seen++) {
            now = model.nextState(now, new Event(pressed.get(seen))).orElseThrow();
            walked.add(now);
        }
        return walked;
    }

    @Test
    void aGarageDoorIsNeverOpenedToCloseIt() {
        HomeTable table = table(HomeEntity.of(HomeKind.COVER), GARAGE);
        assertThat(table.rows())
                .filteredOn(row -> row.command().equals("close"))
                .extracting(HomeTable.Row::state, HomeTable.Row::deed)
                .contains(
                        tuple("Open", Deed.ACTS),
                        tuple("Opening", Deed.ACTS),
                        tuple("Closed", Deed.NOTHING),
                        tuple("Between", Deed.OTHERWISE));
        assertThat(table.rows())
                .filteredOn(
                        row -> row.state().equals("Between") && row.command().equals("close"))
                .extracting(HomeTable.Row::text)
                .containsExactly("refused, since it could lead through Opening, which is shown as opening");
        HomeTable accepted = table(HomeEntity.of(HomeKind.COVER).neverIn("Between", "close"), GARAGE);
        assertThat(accepted.rows())
                .filteredOn(
                        row -> row.state().equals("Between") && row.command().equals("close"))
                .extracting(HomeTable.Row::deed)
                .containsExactly(Deed.REFUSED);
        HomeTable passed = table(HomeEntity.of(HomeKind.COVER).mayPass("Opening"), GARAGE);
        assertThat(passed.rows())
                .noneMatch(row -> row.deed() == Deed.OTHERWISE && row.command().equals("close"));
    }

    @Test
    void aPressThatAGuardMaySendElsewhereIsNotTaken() {
        StateMachine door = Machines.machine(
                "door", "Closed up -> Opening", "Open down [free] -> Closing", "Open down [blocked] -> Opening");
        HomeTable table = table(HomeEntity.of(HomeKind.COVER), door);
        assertThat(table.rows())
                .filteredOn(row -> row.state().equals("Open") && row.command().equals("close"))
                .extracting(HomeTable.Row::deed)
                .containsExactly(Deed.OTHERWISE);
    }

    @Test
    void whatTheEntitySaysAndTheModelLacksIsAMistake() {
        HomeEntity cover = HomeEntity.of(HomeKind.COVER)
                .show("Opn", "open")
                .show("Open", "ajar")
                .command("close", "Open")
                .command("dance", "Open")
                .presses("buton");
        assertThat(table(cover, GARAGE).mistakes())
                .extracting(HomeTable.Mistake::text)
                .anyMatch(text -> text.contains("'Opn' is not a state of the new model") && text.contains("Open"))
                .anyMatch(text -> text.contains("does not show 'ajar'"))
                .anyMatch(text -> text.contains("'close' of a cover would end in 'Open', which is shown as ajar"))
                .anyMatch(text -> text.contains("no command 'dance'"))
                .anyMatch(text -> text.contains("'buton' is no event that a controller may raise"));
        assertThat(table(HomeEntity.of(HomeKind.LOCK), GARAGE).mistakes())
                .extracting(HomeTable.Mistake::text)
                .anyMatch(text -> text.startsWith("as what the lock shows Closed"));
    }

    @Test
    void aNewStateLooksLikeTheStateInWhichItNeedsTheDevice() {
        StateMachine device = Machines.machine("original", "Off on -> On", "On off -> Off");
        StateMachine evolved = Machines.machine(
                "new", "Off on -> On", "On off -> Off", "Off rest -> Rest", "Rest off -> Off", "Rest device Off");
        HomeTable table = HomeTable.of(
                HomeEntity.of(HomeKind.SWITCH), new ModelPair(device, evolved), List.of("on", "off", "rest"));
        assertThat(table.shown(new State("Rest"))).isEqualTo("off");
    }

    @ParameterizedTest
    @MethodSource("kinds")
    void itsDiscoveryIsWhatHomeAssistantTakes(HomeKind kind) {
        HomeEntity entity = entity(kind);
        StateMachine model = model(kind);
        HomeTopics topics = new HomeTopics("thing", "homeassistant");
        String payload = new HomeDiscovery(topics, "thing")
                .entity(entity, table(entity, model))
                .payload(null);
        DiscoverySchema.check(
                payload, Map.of(topics.entity(kind.word()), "{\"state\":\"\",\"mode\":\"\"}"), Set.of(kind.word()));
    }
}
