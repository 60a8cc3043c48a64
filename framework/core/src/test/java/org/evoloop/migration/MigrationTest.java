package org.evoloop.migration;

import static org.assertj.core.api.Assertions.assertThat;
import static org.evoloop.Machines.machine;

import java.util.List;
import java.util.Random;
import java.util.Set;
import org.evoloop.engine.RandomPair;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.DecisionTable;
import org.evoloop.evolution.DeviceEvents;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Step;
import org.evoloop.migration.Carried.How;
import org.evoloop.migration.Carried.What;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.StateMachineBuilder;
import org.junit.jupiter.api.Test;

/** What happens to the states of a music player when another evolution is drawn. */
class MigrationTest {
    private static final StateMachine DEVICE = machine(
            "device",
            "Stopped play -> Playing",
            "Playing stop -> Stopped",
            "Playing pause -> Paused",
            "Paused play -> Playing");
    private static final StateMachine FADING = evolved(
            "fading",
            "Playing fade -> Fading",
            "Fading tm(2s) -> Stopped",
            "Fading stop -> Stopped",
            "Paused doze -> Dozing",
            "Dozing play -> Playing");

    private static StateMachine evolved(String name, String... more) {
        String[] lines = new String[4 + more.length];
        List.of(
                        "Stopped play -> Playing",
                        "Playing stop -> Stopped",
                        "Playing pause -> Paused",
                        "Paused play -> Playing")
                .toArray(lines);
        System.arraycopy(more, 0, lines, 4, more.length);
        return machine(name, lines);
    }

    private static DecisionTable table(StateMachine device, StateMachine evolved) {
        ModelPair pair = new ModelPair(device, evolved);
        return DecisionTable.compile(pair, new DeviceEvents(device.triggers(), Set.of()));
    }

    private static Fate fate(Migration migration, String original, String evolved) {
        Configuration at = new Configuration(new State(original), new State(evolved));
        return migration.lines().stream()
                .filter(line -> line.at().equals(at))
                .findFirst()
                .orElseThrow()
                .fate();
    }

    private static Migration toModel(StateMachine next, Mapping mapping) {
        return Migration.plan(table(DEVICE, FADING), table(DEVICE, next), mapping);
    }

    private static Fate.Maps maps(Fate fate) {
        return (Fate.Maps) fate;
    }

    @Test
    void anEqualModelKeepsEverything() {
        Migration migration = toModel(FADING, Mapping.byName());
        assertThat(migration.isPossible()).isTrue();
        for (Migration.Line line : migration.lines()) {
            assertThat(maps(line.fate()).to()).isEqualTo(line.at());
            assertThat(maps(line.fate()).steps()).isEmpty();
            assertThat(maps(line.fate()).carried()).allMatch(carried -> carried.how() == How.KEPT);
        }
        assertThat(maps(fate(migration, "Playing", "Fading")).carried())
                .extracting(Carried::toString)
                .containsExactly("timer tm(2s) kept", "function Fading kept");
    }

    @Test
    void everyPairThatCanBeReachedHasItsFate() {
        DecisionTable running = table(DEVICE, FADING);
        Migration migration = Migration.plan(running, table(DEVICE, evolved("plain")), Mapping.byName());
        assertThat(migration.lines())
                .extracting(Migration.Line::at)
                .containsExactlyElementsOf(running.configurations());
    }

    @Test
    void aStateThatTheNextModelLacksIsWaitedFor() {
        Migration migration = toModel(evolved("plain"), Mapping.byName());
        Fate.Waits waits = (Fate.Waits) fate(migration, "Playing", "Fading");
        assertThat(waits.exits()).containsExactlyInAnyOrder(new Event("tm(2s)"), new Event("stop"));
        assertThat(waits.uncertain()).as("a timer comes for certain").containsExactly(new Event("stop"));
        assertThat(waits.because()).contains("has no state Fading", "state Fading -> STATE");
        assertThat(migration.isPossible()).isTrue();
    }

    @Test
    void nothingLeadsOutOfATrap() {
        StateMachine trap = evolved("trap", "Playing fade -> Fading", "Fading again -> Fading");
        Migration migration = Migration.plan(table(DEVICE, trap), table(DEVICE, evolved("plain")), Mapping.byName());
        assertThat(fate(migration, "Playing", "Fading")).isInstanceOf(Fate.Stuck.class);
        assertThat(migration.isPossible()).isFalse();
    }

    @Test
    void whereDeviceAndNextModelCannotStandTogetherEventsAreSent() {
        Mapping mapping = Mapping.byName().withState(new State("Fading"), new State("Paused"));
        Fate.Maps maps = maps(fate(toModel(evolved("plain"), mapping), "Playing", "Fading"));
        assertThat(maps.to()).isEqualTo(new Configuration(new State("Paused"), new State("Paused")));
        assertThat(maps.steps()).extracting(Step::trigger).containsExactly(new Event("pause"));
    }

    @Test
    void aFunctionThatNeedsAnotherStateOfTheDeviceHasItTakenThere() {
        StateMachine next = evolved("next", "Stopped doze -> Fading", "Fading play -> Playing");
        Fate.Maps maps = maps(fate(toModel(next, Mapping.byName()), "Playing", "Fading"));
        assertThat(maps.to()).isEqualTo(new Configuration(new State("Stopped"), new State("Fading")));
        assertThat(maps.steps()).extracting(Step::trigger).containsExactly(new Event("stop"));
    }

    @Test
    void aDeviceThatCannotBeTakenThereIsStuck() {
        StateMachine next = evolved("next", "Stopped doze -> Fading", "Fading play -> Playing");
        ModelPair pair = new ModelPair(DEVICE, next);
        DecisionTable deaf = DecisionTable.compile(pair, new DeviceEvents(Set.of(), DEVICE.triggers()));
        StateMachine trap = evolved("trap", "Playing doze -> Fading");
        Fate fate = fate(Migration.plan(table(DEVICE, trap), deaf, Mapping.byName()), "Playing", "Fading");
        assertThat(((Fate.Stuck) fate).because()).contains("the new model is in Fading", "with the device in Playing");
    }

    @Test
    void timersAndFunctionsContinueEndOrBegin() {
        StateMachine next = evolved(
                "next",
                "Playing mute -> Muting",
                "Muting tm(3s) -> Stopped",
                "Paused doze -> Dozing",
                "Dozing tm(9s) -> Playing");
        State fading = new State("Fading");
        Mapping.TimerOf timer = new Mapping.TimerOf(fading, "tm(2s)");
        Mapping moved = Mapping.byName().withState(fading, new State("Muting"));
        assertThat(carried(next, moved, "Playing", "Fading"))
                .containsExactly(
                        new Carried(What.TIMER, "tm(2s)", "tm(2s)", How.ENDED),
                        new Carried(What.TIMER, "tm(3s)", "tm(3s)", How.STARTED),
                        new Carried(What.FUNCTION, "Fading", "Fading", How.ENDED),
                        new Carried(What.FUNCTION, "Muting", "Muting", How.STARTED));
        assertThat(carried(next, moved.withTimer(timer, "tm(3s)").withFunction(fading, true), "Playing", "Fading"))
                .containsExactly(
                        new Carried(What.TIMER, "tm(2s)", "tm(3s)", How.KEPT),
                        new Carried(What.FUNCTION, "Fading", "Muting", How.KEPT))
                .extracting(Carried::toString)
                .containsExactly("timer tm(2s) kept as tm(3s)", "function Fading kept as Muting");
        assertThat(carried(next, moved, "Paused", "Dozing"))
                .containsExactly(
                        new Carried(What.TIMER, "tm(9s)", "tm(9s)", How.STARTED),
                        new Carried(What.FUNCTION, "Dozing", "Dozing", How.KEPT));
    }

    @Test
    void whatIsToBeginAnewDoes() {
        State fading = new State("Fading");
        Mapping mapping = Mapping.byName()
                .withRestarted(new Mapping.TimerOf(fading, "tm(2s)"))
                .withFunction(fading, false);
        assertThat(carried(FADING, mapping, "Playing", "Fading"))
                .extracting(Carried::how)
                .containsOnly(How.RESTARTED);
    }

    private static List<Carried> carried(StateMachine next, Mapping mapping, String original, String evolved) {
        return maps(fate(toModel(next, mapping), original, evolved)).carried();
    }

    @Test
    void aDeviceWithOtherFirmwareMapsItsStates() {
        StateMachine firmware = machine(
                "firmware",
                "Ready play -> Playing",
                "Playing stop -> Ready",
                "Playing pause -> Paused",
                "Paused play -> Playing");
        StateMachine next = machine(
                "next",
                "Ready play -> Playing",
                "Playing stop -> Ready",
                "Playing pause -> Paused",
                "Paused play -> Playing");
        DecisionTable running = table(DEVICE, FADING);
        Migration byName = Migration.plan(running, table(firmware, next), Mapping.byName());
        Fate.Waits waits = (Fate.Waits) fate(byName, "Stopped", "Stopped");
        assertThat(waits.because()).contains("original model has no state Stopped", "device Stopped -> STATE");

        Mapping mapping = Mapping.byName()
                .withDeviceState(new State("Stopped"), new State("Ready"))
                .withState(new State("Stopped"), new State("Ready"));
        Migration mapped = Migration.plan(running, table(firmware, next), mapping);
        assertThat(maps(fate(mapped, "Stopped", "Stopped")).to())
                .isEqualTo(new Configuration(new State("Ready"), new State("Ready")));
    }

    @Test
    void whatIsPlannedForRandomModelsHolds() {
        int sent = 0;
        int waited = 0;
        int stuck = 0;
        Random random = new Random(20_261_123);
        for (int seed = 0; seed < 2_000; seed++) {
            ModelPair before = RandomPair.models(seed);
            ModelPair other = RandomPair.models(seed + 100_000);
            ModelPair after = new ModelPair(before.original(), other.evolved());
            DeviceEvents device = new DeviceEvents(Set.of(new Event("a")), Set.of(new Event("x")));
            DecisionTable running = DecisionTable.compile(before, device);
            DecisionTable next = DecisionTable.compile(after, device);
            Mapping mapping = Mapping.byName();
            if (random.nextBoolean()) {
                List<State> states = List.copyOf(after.evolved().states());
                mapping = mapping.withState(new State("N"), states.get(random.nextInt(states.size())));
            }
            Migration migration = Migration.plan(running, next, mapping);
            assertThat(migration.lines()).hasSameSizeAs(running.configurations());
            for (Migration.Line line : migration.lines()) {
                if (line.fate() instanceof Fate.Maps maps) {
                    assertStands(next, maps);
                    sent += maps.steps().isEmpty() ? 0 : 1;
                } else if (line.fate() instanceof Fate.Waits waits) {
                    assertThat(waits.exits()).isNotEmpty();
                    waited++;
                } else {
                    stuck++;
                }
            }
        }
        assertThat(sent).isPositive();
        assertThat(waited).isPositive();
        assertThat(stuck).isPositive();
    }

    /** The steps lead there one after another, and the next models can be in the states where they end. */
    private static void assertStands(DecisionTable next, Fate.Maps maps) {
        State at = maps.steps().isEmpty()
                ? maps.to().original()
                : maps.steps().get(0).source();
        for (Step step : maps.steps()) {
            assertThat(step.source()).isEqualTo(at);
            assertThat(next.device().sendable()).contains(step.trigger());
            at = step.target();
        }
        assertThat(at).isEqualTo(maps.to().original());
        List<State> same = next.models().deviceStates(maps.to().evolved());
        assertThat(next.configurations().contains(maps.to()) || same.contains(at))
                .as(maps.toString())
                .isTrue();
    }

    /** A lamp that remembers how bright it was. */
    private static DecisionTable remembering() {
        StateMachine device = machine("lamp", "Off on -> Bright", "Bright off -> Off");
        StateMachineBuilder builder = StateMachine.named("remembering").initial("Off");
        builder.drawn(new State("Off [history Dim]"), new State("Off"), List.of(), List.of("Off"), false);
        StateMachine evolved = builder.transition("Off", "on", "Bright")
                .transition("Bright", "off", "Off")
                .transition("Bright", "dim", "Dim")
                .transition("Dim", "off", "Off [history Dim]")
                .transition("Off [history Dim]", "on", "Dim")
                .build();
        return table(device, evolved);
    }

    private static String afterRemembering(String system, Mapping mapping) {
        Migration migration = Migration.plan(remembering(), remembering(), mapping);
        return maps(fate(migration, "Off", system)).to().evolved().name();
    }

    @Test
    void whatAStateRemembersIsKept() {
        assertThat(afterRemembering("Off [history Dim]", Mapping.byName())).isEqualTo("Off [history Dim]");
        assertThat(afterRemembering("Off", Mapping.byName())).isEqualTo("Off");
    }

    @Test
    void aMappingMayNameWhatIsRemembered() {
        State off = new State("Off");
        State dimmed = new State("Off [history Dim]");

        assertThat(afterRemembering("Off", Mapping.byName().withState(off, dimmed)))
                .isEqualTo("Off [history Dim]");
        assertThat(afterRemembering("Off [history Dim]", Mapping.byName().withState(dimmed, off)))
                .isEqualTo("Off");
    }
}
