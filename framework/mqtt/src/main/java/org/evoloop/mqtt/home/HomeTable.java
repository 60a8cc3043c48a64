package org.evoloop.mqtt.home;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.evoloop.evolution.ModelPair;
import org.evoloop.statemachine.Names;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.Transition;
import org.jspecify.annotations.Nullable;

/**
 * What each command of an entity does in each state of a new model. {@link HomeAssistant} obeys by this table.
 *
 * <p>Threading: immutable.
 *
 * @since 0.1
 */
public final class HomeTable {
    /** Ends a preset; Home Assistant offers it wherever there are presets. */
    public static final String NO_MODE = "none";

    private final HomeEntity entity;
    private final StateMachine evolved;
    private final Set<String> raisable;
    private final Map<State, String> shown = new LinkedHashMap<>();
    private final Map<String, List<State>> modes = new LinkedHashMap<>();
    private final Map<String, List<State>> goals = new LinkedHashMap<>();
    private final List<Mistake> mistakes = new ArrayList<>();
    private final Set<State> mayPass = new LinkedHashSet<>();

    /**
     * Something that an entity says and the models do not have.
     *
     * @param key the part of the entity: {@code states}, {@code modes}, {@code commands}, {@code may-pass}, {@code never-in}
     *     or {@code presses}; empty for the whole
     * @param name the name there
     * @param text what is wrong
     */
    public record Mistake(String key, String name, String text) {}

    /** What a command does. */
    public enum Deed {
        /** It presses events. */
        ACTS,
        /** There is nothing to do. */
        NOTHING,
        /** It cannot be done, and is refused. */
        REFUSED,
        /** It could be done only by way of something that the command does not mean, so it is refused. */
        OTHERWISE
    }

    /**
     * What a command does in a state.
     *
     * @param state of the new model
     * @param shown as what it is shown
     * @param text what happens, or why it does not
     */
    public record Row(String state, String shown, String command, Deed deed, String text) {
        @Override
        public String toString() {
            return command + " in " + state + (shown.isEmpty() ? "" : " (" + shown + ")") + ": " + text;
        }
    }

    /** A command in a state, with the way that it takes. */
    record Decision(Deed deed, String text, @Nullable Way way, List<State> goals) {}

    /**
     * The table of an entity.
     *
     * @param controllerEvents the events that a controller may raise
     */
    public static HomeTable of(HomeEntity entity, ModelPair models, Collection<String> controllerEvents) {
        HomeTable table = new HomeTable(entity, models.evolved(), controllerEvents);
        table.readStates(models);
        table.readNames(controllerEvents);
        return table;
    }

    private HomeTable(HomeEntity entity, StateMachine evolved, Collection<String> controllerEvents) {
        this.entity = entity;
        this.evolved = evolved;
        this.raisable = new TreeSet<>(entity.pressed().isEmpty() ? controllerEvents : entity.pressed());
    }

    private void readStates(ModelPair models) {
        HomeKind kind = entity.kind();
        entity.shownStates().forEach((state, as) -> {
            List<State> known = states("states", state);
            if (!kind.shown().contains(as)) {
                mistakes.add(new Mistake(
                        "states",
                        state,
                        "a " + kind.word() + " does not show '" + as + "', but one of "
                                + String.join(", ", new TreeSet<>(kind.shown()))));
            }
            known.forEach(each -> shown.put(each, as));
        });
        entity.modes()
                .forEach((mode, each) -> modes.put(
                        mode,
                        each.stream()
                                .flatMap(state -> states("modes", state).stream())
                                .toList()));
        if (kind.shown().isEmpty()) {
            return;
        }
        List<String> open = new ArrayList<>();
        for (State state : evolved.states()) {
            String as = shown.containsKey(state) ? shown.get(state) : byName(state, models);
            if (as != null) {
                shown.put(state, as);
            }
        }
        boolean rest = kind.isOnOrOff() && shown.containsValue("off");
        for (State state : evolved.states()) {
            if (!shown.containsKey(state) && !evolved.isEnd(state)) {
                if (rest) {
                    shown.put(state, "on");
                } else {
                    open.add(evolved.withoutMemory(state).name());
                }
            }
        }
        if (!open.isEmpty()) {
            mistakes.add(new Mistake(
                    "",
                    "",
                    "as what the " + kind.word() + " shows "
                            + open.stream().distinct().collect(Collectors.joining(", "))
                            + " is not known; add to states one of "
                            + String.join(", ", new TreeSet<>(kind.shown()))));
        }
    }

    private @Nullable String byName(State state, ModelPair models) {
        HomeKind kind = entity.kind();
        String as = kind.shownBy(evolved.withoutMemory(state).name());
        if (as != null) {
            return as;
        }
        // A new state that needs the device in a state looks like that state.
        List<String> byDevice = models.isNew(state)
                ? models.whereDeviceMustBe(state).stream()
                        .map(device -> entity.shownStates().containsKey(device.name())
                                ? entity.shownStates().get(device.name())
                                : kind.shownBy(device.name()))
                        .distinct()
                        .toList()
                : List.of();
        return byDevice.size() == 1 && byDevice.get(0) != null
                ? byDevice.get(0)
                : entity.hooks().shown(state, models);
    }

    private void readNames(Collection<String> controllerEvents) {
        HomeKind kind = entity.kind();
        entity.goals().forEach((command, state) -> {
            List<State> goal = states("commands", state);
            HomeKind.Command known = kind.command(command);
            if (known == null) {
                mistakes.add(new Mistake(
                        "commands",
                        command,
                        "a " + kind.word() + " has no command '" + command + "'"
                                + Names.hint(command, kind.commands())));
                return;
            }
            goals.put(command, goal);
            Set<String> ends = command.equals("clean_spot") ? Set.of("cleaning") : known.ends();
            goal.stream()
                    .filter(each -> !ends.isEmpty() && !ends.contains(shown.get(each)))
                    .findFirst()
                    .ifPresent(each -> mistakes.add(new Mistake(
                            "commands",
                            command,
                            "'" + command + "' of a " + kind.word() + " would end in '" + state
                                    + "', which is shown as " + shown.get(each) + "; it may end in what is shown as "
                                    + String.join(" or ", new TreeSet<>(ends)))));
        });
        entity.passed().forEach(state -> mayPass.addAll(states("may-pass", state)));
        entity.pressed().forEach(event -> {
            if (!controllerEvents.contains(event)) {
                mistakes.add(new Mistake(
                        "presses",
                        event,
                        "'" + event + "' is no event that a controller may raise"
                                + Names.hint(event, controllerEvents)));
            }
        });
    }

    private List<State> states(String key, String name) {
        List<State> known = evolved.alike(new State(name));
        if (known.isEmpty()) {
            List<String> all = evolved.states().stream().map(State::name).toList();
            mistakes.add(new Mistake(
                    key,
                    name,
                    "'" + Names.inOneLine(name) + "' is not a state of the new model" + Names.hint(name, all)));
        }
        return known;
    }

    /** What the entity says and the models do not have. */
    public List<Mistake> mistakes() {
        return List.copyOf(mistakes);
    }

    /** What a state is shown as; empty if that is not known. */
    public String shown(State state) {
        String as = shown.get(state);
        return as == null ? "" : as;
    }

    /** All that states are shown as. */
    Set<String> shownStates() {
        return new TreeSet<>(shown.values());
    }

    /** The modes that the model has. */
    List<String> modes() {
        return modes.entrySet().stream()
                .filter(each -> !each.getValue().isEmpty())
                .map(Map.Entry::getKey)
                .toList();
    }

    /** Which mode a state is; empty if none. */
    String mode(State state) {
        return modes.entrySet().stream()
                .filter(each -> each.getValue().contains(state))
                .map(Map.Entry::getKey)
                .findFirst()
                .orElse("");
    }

    /** The commands that lead somewhere in some state, without those of modes. */
    public List<String> commands() {
        return entity.kind().commands().stream()
                .filter(command -> evolved.states().stream()
                        .anyMatch(state -> decide(state, command, shown(state)).deed() == Deed.ACTS))
                .toList();
    }

    /** The commands of modes, each with its word. */
    List<String> modeCommands() {
        if (entity.kind() == HomeKind.EVENT) {
            return List.of();
        }
        List<String> commands = new ArrayList<>();
        modes().forEach(mode -> commands.add(modeCommand(mode)));
        if (hasNoMode()) {
            commands.add(modeCommand(NO_MODE));
        }
        return commands;
    }

    String modeCommand(String mode) {
        return entity.kind().modeWord() + " " + mode;
    }

    /** What every command does in every state. */
    public List<Row> rows() {
        List<String> offered = new ArrayList<>(commands());
        // What leads nowhere, but could by a way of another meaning, has its rows, too.
        for (String command : entity.kind().commands()) {
            boolean otherwise = evolved.states().stream()
                    .anyMatch(state -> decide(state, command, shown(state)).deed() == Deed.OTHERWISE);
            if (otherwise && !offered.contains(command)) {
                offered.add(command);
            }
        }
        offered.addAll(modeCommands());
        List<Row> rows = new ArrayList<>();
        for (State state : evolved.states()) {
            for (String command : evolved.isEnd(state) ? List.<String>of() : offered) {
                Decision decided = decide(state, command, shown(state));
                rows.add(new Row(state.name(), shown(state), command, decided.deed(), decided.text()));
            }
        }
        return rows;
    }

    /**
     * The events that a command presses in a state, one after another, until a timer is waited for; none if there is nothing
     * to do, or it is refused.
     */
    public List<String> presses(State now, String command) {
        Decision decided = decide(now, command, shown(now));
        Way way = decided.way();
        List<String> presses = new ArrayList<>();
        for (Transition each : way == null ? List.<Transition>of() : way.from(now, decided.goals())) {
            if (!raisable.contains(each.event().trigger().name())) {
                break;
            }
            presses.add(each.event().trigger().name());
        }
        return presses;
    }

    /**
     * What a command does now.
     *
     * @param now the state of the new model
     * @param as what the entity shows
     */
    Decision decide(State now, String command, String as) {
        String mode = modeOf(command);
        HomeKind.Command known = entity.kind().command(command);
        if (mode == null && known == null) {
            return refused("a " + entity.kind().word() + " does not know the command " + command);
        }
        List<List<State>> choices = mode != null ? List.of(modeStates(mode, as)) : goals(command);
        boolean isThere = choices.stream().anyMatch(to -> to.contains(now))
                || (mode == null
                        && known != null
                        && entity.hooks().goals(command, evolved) == null
                        && isMeant(command, known, as, now));
        boolean isIdle = known != null && !known.in().isEmpty() && !known.in().contains(as);
        if (isThere || isIdle) {
            return new Decision(
                    Deed.NOTHING,
                    isThere ? "nothing, it is there" : "nothing, there is nothing to end",
                    null,
                    List.of());
        }
        String state = evolved.withoutMemory(now).name();
        if (entity.neverIn(state).contains(command)) {
            return refused("never in " + state);
        }
        Decision first = null;
        for (List<State> to : choices) {
            Decision decided = lead(now, known, as, to);
            if (decided.deed() == Deed.ACTS) {
                return decided;
            }
            first = first == null ? decided : first;
        }
        return first == null ? refused("the new model has no state for " + command) : first;
    }

    /** Whether what is shown now is what the command means first, as far as the model has that. */
    private boolean isMeant(String command, HomeKind.Command known, String as, State now) {
        return known.to().stream()
                .filter(shownAs ->
                        shownAs.contains(as) || !ends(command, shownAs).isEmpty())
                .findFirst()
                .filter(shownAs -> shownAs.contains(as) && isSettled(now, shownAs))
                .isPresent();
    }

    /** Leads to one of these states. */
    private Decision lead(State now, HomeKind.@Nullable Command known, String as, List<State> to) {
        Set<String> meant = new LinkedHashSet<>(known == null ? Set.of() : known.ends());
        to.forEach(goal -> meant.add(shown(goal)));
        if (known != null) {
            meant.addAll(known.past());
        }
        Set<String> alsoNow = new LinkedHashSet<>(meant);
        alsoNow.add(as);
        Way strict = strict(alsoNow);
        List<Transition> way = strict.from(now, to);
        if (returns(way, as) && !meant.contains(as)) {
            // What it does now is not begun again.
            strict = strict(meant);
            way = strict.from(now, to);
        }
        if (!way.isEmpty()) {
            return new Decision(Deed.ACTS, describe(way), strict, to);
        }
        List<Transition> other = new Way(evolved, raisable, any -> true, true).from(now, to);
        return other.isEmpty()
                ? refused("nothing that a controller may raise leads from " + now + " to " + names(to))
                : new Decision(Deed.OTHERWISE, otherwise(other, to, strict), null, List.of());
    }

    private Way strict(Set<String> passable) {
        boolean anyMayPass = entity.kind().shown().isEmpty();
        return new Way(
                evolved,
                raisable,
                passed -> anyMayPass || mayPass.contains(passed) || passable.contains(shown(passed)),
                true);
    }

    /** Whether a way leaves what is shown now, and comes back to it. */
    private boolean returns(List<Transition> way, String as) {
        boolean left = false;
        for (Transition each : way) {
            boolean isSame = shown(each.target()).equals(as);
            if (left && isSame) {
                return true;
            }
            left |= !isSame;
        }
        return false;
    }

    private static Decision refused(String why) {
        return new Decision(Deed.REFUSED, "refused, " + why, null, List.of());
    }

    private static String names(List<State> states) {
        return states.stream().map(State::name).collect(Collectors.joining(" or "));
    }

    private @Nullable String modeOf(String command) {
        String start = entity.kind().modeWord() + " ";
        String mode = command.startsWith(start) ? command.substring(start.length()) : null;
        return mode != null && (modes.containsKey(mode) || (mode.equals(NO_MODE) && hasNoMode())) ? mode : null;
    }

    private boolean hasNoMode() {
        return entity.kind() == HomeKind.CLIMATE && !modes.isEmpty();
    }

    /** Which states are a mode; without a mode, those that are none and shown as now. */
    private List<State> modeStates(String mode, String as) {
        List<State> said = modes.get(mode);
        return said != null
                ? said
                : evolved.states().stream()
                        .filter(state -> mode(state).isEmpty() && shown(state).equals(as))
                        .toList();
    }

    /** The states that the entity says; null if it says none. */
    private @Nullable List<State> saidGoals(String command) {
        List<State> said = goals.get(command);
        return said == null ? entity.hooks().goals(command, evolved) : said;
    }

    /** The states to which a command leads; those of a later list, if there is no way to one of an earlier list. */
    private List<List<State>> goals(String command) {
        List<State> said = saidGoals(command);
        HomeKind.Command known = entity.kind().command(command);
        if (said != null || known == null) {
            return said == null || said.isEmpty() ? List.of() : List.of(said);
        }
        return known.to().stream()
                .map(shownAs -> ends(command, shownAs))
                .filter(found -> !found.isEmpty())
                .toList();
    }

    /** The states that are shown as one of these, and stay so; first those whose own names say so. */
    private List<State> ends(String command, Set<String> shownAs) {
        List<State> spots = command.equals("clean_spot") ? List.of() : goals.getOrDefault("clean_spot", List.of());
        return evolved.states().stream()
                .filter(state -> shownAs.contains(shown(state)) && isSettled(state, shownAs) && !spots.contains(state))
                .sorted(Comparator.comparing(state ->
                        entity.kind().shownBy(evolved.withoutMemory(state).name()) == null))
                .toList();
    }

    /** Whether no timer that is due soon leads from a state to one that is shown otherwise. */
    private boolean isSettled(State state, Set<String> shownAs) {
        return evolved.transitionsFrom(state).stream()
                .noneMatch(each -> Way.isSoon(each.event()) && !shownAs.contains(shown(each.target())));
    }

    private String describe(List<Transition> way) {
        return way.stream()
                        .map(each -> raisable.contains(each.event().trigger().name())
                                ? "presses " + each.event().trigger()
                                : "waits (" + each.event().trigger() + ")")
                        .collect(Collectors.joining(", "))
                + ", to "
                + way.get(way.size() - 1).target();
    }

    private String otherwise(List<Transition> way, List<State> to, Way strict) {
        return way.stream()
                .flatMap(each -> strict.targets(each.source(), each.event()).stream())
                .filter(target -> !to.contains(target) && !strict.mayPass().test(target))
                .findFirst()
                .map(this::through)
                .orElse("refused, every way leads through something else");
    }

    private String through(State state) {
        return "refused, since it could lead through " + state + ", which is shown as " + shown(state);
    }
}
