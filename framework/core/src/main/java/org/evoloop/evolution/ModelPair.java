package org.evoloop.evolution;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import java.util.stream.Collectors;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.ModelException;
import org.evoloop.statemachine.Names;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.Transition;

/**
 * The two models of an evolution: the device as it is and the device as its owner wants it (the paper's Sys_o and
 * Sys_n). The paper's "new" is called "evolved" in code, where {@code new} is a keyword.
 *
 * <p>Threading: immutable.
 *
 * @param original what the device does by itself
 * @param evolved what device and converter do together
 * @since 0.1
 */
public record ModelPair(StateMachine original, StateMachine evolved) {
    /**
     * Gives states that are drawn in the same place the same name, whatever other states their machines have. Device
     * states that are named follow them.
     *
     * @throws NullPointerException if one of them is null; the message says which
     */
    public ModelPair {
        Objects.requireNonNull(original, "the original model is null");
        Objects.requireNonNull(evolved, "the new model is null");
        Namesakes namesakes = new Namesakes(original, evolved);
        original = namesakes.original();
        evolved = namesakes.evolved();
    }

    /** Something of the original model that the new model lacks, against Definition IV.1 of the paper. */
    public sealed interface Violation permits MissingState, Violation.MissingEvent {
        /** Condition 1, E_o is a subset of E_n: {@code event} is missing in the new model. */
        record MissingEvent(Event event) implements Violation {
            @Override
            public String toString() {
                return "Condition 1: event " + event + " is missing in the new model";
            }
        }
    }

    /** Every violation of Conditions 1 and 2, events first; empty if the pair is an evolution. */
    public List<Violation> violations() {
        List<Violation> found = new ArrayList<>();
        for (Event event : original.events()) {
            if (!evolved.events().contains(event)) {
                found.add(new Violation.MissingEvent(event));
            }
        }
        for (State state : original.states()) {
            if (evolvedStates(state).isEmpty()) {
                found.add(MissingState.of(state, original, evolved));
            }
        }
        return found;
    }

    /**
     * Refuses a pair that is not an evolution.
     *
     * @throws ModelException naming every violation of Conditions 1 and 2, and both initial states if they differ; or every
     *     device state that cannot be
     */
    public void requireValid() {
        List<Event> added = evolved.events().stream()
                .filter(event -> !original.events().contains(event))
                .toList();
        List<String> problems = new ArrayList<>();
        for (Violation violation : violations()) {
            problems.add(violation
                    + (violation instanceof Violation.MissingEvent missing
                            ? Names.meant(missing.event().name(), added)
                            : ""));
        }
        if (!deviceStates(evolved.initial()).contains(original.initial())) {
            problems.add("the new model starts in " + evolved.initial() + ", the device in " + original.initial());
        }
        if (!problems.isEmpty()) {
            boolean swapped = new ModelPair(/* original= */ evolved, /* evolved= */ original)
                    .violations()
                    .isEmpty();
            String all = String.join("; ", problems)
                    + (swapped ? ". The other way round they would be: are the two models swapped?" : "");
            throw new ModelException("the models '" + original.name() + "' and '" + evolved.name()
                    + "' are not an evolution: " + all + (all.endsWith("?") ? " " : ". ")
                    + "The new model must keep every state and event of the device; names are case-sensitive");
        }
        List<DeviceStateProblem> deviceStates = deviceStateProblems();
        if (!deviceStates.isEmpty()) {
            throw new ModelException("the new model '" + evolved.name() + "': "
                    + deviceStates.stream().map(DeviceStateProblem::toString).collect(Collectors.joining("; ")));
        }
    }

    /** The events that are {@linkplain StateMachine#urgent urgent} in either model. */
    public Set<Event> urgent() {
        Set<Event> all = new LinkedHashSet<>(evolved.urgent());
        all.addAll(original.urgent());
        return all;
    }

    /** Whether any event is {@linkplain StateMachine#urgent urgent} in either model. */
    public boolean hasUrgent() {
        return !evolved.urgent().isEmpty() || !original.urgent().isEmpty();
    }

    /** Whether {@code event} is {@linkplain StateMachine#urgent urgent} in either model, with or without guards. */
    public boolean isUrgent(Event event) {
        Event trigger = event.trigger();
        return evolved.urgent().contains(trigger) || original.urgent().contains(trigger);
    }

    /** The same models without urgent events. */
    public ModelPair withoutUrgent() {
        return new ModelPair(original.withoutUrgent(), evolved.withoutUrgent());
    }

    /** The initial states of both machines. */
    public Configuration initial() {
        return new Configuration(original.initial(), evolved.initial());
    }

    /**
     * The device's states that correspond to {@code state} of the new model: the one of the same name, or all that
     * differ from it only in the history that a machine remembers. Empty for a new state.
     */
    public List<State> deviceStates(State state) {
        List<State> same = original.alike(state);
        return same.isEmpty() ? original.alike(evolved.withoutMemory(state)) : same;
    }

    /**
     * The new model's states that correspond to {@code state} of the device, in the order of the new model; none only
     * if the pair is not an evolution.
     */
    public List<State> evolvedStates(State state) {
        List<State> same = evolved.alike(state);
        return same.isEmpty() ? evolved.alike(original.withoutMemory(state)) : same;
    }

    /**
     * Where the device must be in {@code state} of the new model: the {@linkplain #deviceStates corresponding} states,
     * or for a new state with a {@linkplain StateMachine#deviceState device state} those that it names. Empty if the
     * device may be anywhere.
     */
    public List<State> whereDeviceMustBe(State state) {
        List<State> own = deviceStates(state);
        String named = own.isEmpty() ? evolved.deviceState(state) : null;
        return named == null ? own : named(named);
    }

    /**
     * The new model's state for people, with where the device is if the state is a new one that needs it somewhere: {@code
     * Gap, the device in StopUp}.
     */
    public String describe(Configuration at) {
        boolean needs = isNew(at.evolved()) && !whereDeviceMustBe(at.evolved()).isEmpty();
        return needs
                ? describe(at.evolved(), at.original().name())
                : at.evolved().name();
    }

    /** The same for a state that needs the device in {@code device}. */
    public static String describe(State state, String device) {
        return state + ", the device in " + device;
    }

    /**
     * Why {@code occurrence} is not acceptable, if guards are the reason: {@code not acceptable in F: [light load] is
     * false for load=400}. Empty if the new model draws no transition for its event.
     */
    public String guardsThatDoNotHold(Configuration at, Occurrence occurrence) {
        if (!(occurrence instanceof Occurrence.Heard heard) || !evolved.hasTrigger(at.evolved(), heard.event())) {
            return "";
        }
        Event trigger = heard.event().trigger();
        List<String> guards = evolved.transitionsFrom(at.evolved()).stream()
                .map(Transition::event)
                .filter(event ->
                        event.trigger().equals(trigger) && !event.guards().isEmpty())
                .map(event -> "[" + String.join("] [", event.guards()) + "]")
                .toList();
        if (guards.isEmpty()) {
            return "";
        }
        boolean one = guards.size() == 1 && !guards.get(0).contains("] [");
        return "not acceptable in " + at.evolved() + ": "
                + (one ? guards.get(0) + " is false" : "none of " + String.join(", ", guards) + " holds")
                + (occurrence.values().isEmpty() ? "" : " for " + occurrence.values());
    }

    /** The original's states of this name; if there is none, those drawn at this path or inside it. */
    private List<State> named(String nameOrPath) {
        List<State> same = original.alike(new State(nameOrPath));
        return same.isEmpty()
                ? original.states().stream()
                        .filter(state -> original.paths(state).stream()
                                .anyMatch(path -> path.equals(nameOrPath) || path.startsWith(nameOrPath + '.')))
                        .toList()
                : same;
    }

    /**
     * A device state that cannot be.
     *
     * @param state the state of the new model
     * @param message what is wrong
     * @param remedy how to fix it
     */
    public record DeviceStateProblem(State state, String message, String remedy) {
        /** For messages: both. */
        @Override
        public String toString() {
            return message + "; " + remedy;
        }
    }

    /**
     * What is wrong with the device states of the new model; empty if nothing is. One that several states share, such as
     * those of a composite state, is reported for the first of them.
     */
    public List<DeviceStateProblem> deviceStateProblems() {
        List<DeviceStateProblem> problems = new ArrayList<>();
        Set<Object> reported = new HashSet<>();
        for (State state : evolved.states()) {
            String device = evolved.deviceState(state);
            if (device == null) {
                continue;
            }
            State plain = evolved.withoutMemory(state);
            if (isNew(state) && named(device).isEmpty() && reported.add(device)) {
                problems.add(new DeviceStateProblem(
                        state,
                        "the device state of " + plain + ", " + Names.shown(device)
                                + ", is not a state of the original model",
                        Names.hint(device, original.states()).substring(2)));
            } else if (!isNew(state) && !evolved.inheritsDeviceState(state) && reported.add(plain)) {
                problems.add(new DeviceStateProblem(
                        state,
                        "the device has state " + plain + " itself, so it can have no other device state",
                        "remove " + Names.shown(device)));
            }
        }
        return problems;
    }

    /** Whether only the new model has {@code state}: a function that the converter runs. */
    public boolean isNew(State state) {
        return !original.hasAlike(state) && !original.hasAlike(evolved.withoutMemory(state));
    }
}
