package org.evoloop.statemachine;

import static java.util.Objects.requireNonNull;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.UnaryOperator;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;

/**
 * Collects the parts of a {@link StateMachine}; {@link #build()} reports every problem at once.
 *
 * <p>Nothing given to it may be null: each method throws a {@link NullPointerException} that says what is. One that takes
 * the name of a state or an event throws a {@link ModelException} if it is blank.
 *
 * <p>Threading: not thread-safe.
 *
 * @since 0.1
 */
public final class StateMachineBuilder {
    private static final Pattern GUARD = Pattern.compile("\\[([^\\[\\]]+)]");
    private static final Pattern GUARDED = Pattern.compile("(.*?\\S)((?:\\s+" + GUARD + ")+)");

    private static final String NO_TRANSITION = "a transition of a state machine is null";
    private static final String ACTIVITIES =
            "the activities of a state are null, or one of them is; List.of() are none";

    private final String name;
    /** By the states, in their order. */
    private Map<State, Row> rows = new LinkedHashMap<>();
    /** Whether the last machine built has the rows; they are copied before the next change. */
    private boolean built;

    private final Set<Event> events = new LinkedHashSet<>();
    /** Those that are named without being drawn on a transition or deferred. */
    private final Set<Event> named = new HashSet<>();
    /** Only for transitions with a place. */
    private final IdentityHashMap<Transition, String> places = new IdentityHashMap<>();

    private final List<String> problems = new ArrayList<>();
    private final Set<Event> spontaneous = new LinkedHashSet<>();
    private final Set<Event> urgent = new LinkedHashSet<>();
    private final List<String> initialEffects = new ArrayList<>();
    private final Map<State, StateTraits> traits = new LinkedHashMap<>();
    private @Nullable State initial;
    private @Nullable TransitionDraft draft;

    StateMachineBuilder(String name) {
        this.name = requireNonNull(name, "the name of a state machine is null");
    }

    /** The state in which the machine starts. */
    public StateMachineBuilder initial(String state) {
        State candidate = new State(state);
        if (initial != null && !initial.equals(candidate)) {
            problems.add("two initial states, " + initial + " and " + candidate + "; keep one");
        }
        initial = candidate;
        row(candidate);
        return this;
    }

    /** Adds a state; not needed for states named by a transition or {@link #initial}. */
    public StateMachineBuilder state(String state) {
        row(new State(state));
        return this;
    }

    private Row row(State state) {
        requireNonNull(state, "a state of a state machine is null");
        if (built) {
            rows = new LinkedHashMap<>(rows);
            rows.replaceAll((each, row) -> new Row(row));
            built = false;
        }
        Row row = rows.get(state);
        if (row == null) {
            row = new Row(state);
            rows.put(state, row);
        }
        return row;
    }

    /** Adds behaviors that run when the machine starts. */
    public StateMachineBuilder initialEffects(List<String> effects) {
        Names.requireAll(effects, "the initial effects are null, or one of them is; List.of() are none");
        initialEffects.addAll(effects);
        return this;
    }

    /** Adds a state and the behaviors that run while it lasts. */
    public StateMachineBuilder activities(String state, List<String> names) {
        Names.requireAll(names, ACTIVITIES);
        return names.isEmpty() ? state(state) : traits(state, known -> known.withActivities(names));
    }

    /**
     * Adds a state that defers an event, see {@link StateMachine#defers}.
     *
     * @param event the event, with guards if it is deferred only under those
     */
    public StateMachineBuilder defers(String state, Event event) {
        addEvent(requireNonNull(event, "the event that a state defers is null"), "");
        named.remove(event);
        return traits(state, known -> known.withDeferred(event));
    }

    /**
     * Adds a new state in which the device must be in a certain state, see {@link StateMachine#deviceState}.
     *
     * @param deviceState the name of a state of the original model, or its path
     */
    public StateMachineBuilder deviceState(String state, String deviceState) {
        // A name that is none is refused as it is for any other state.
        String device = new State(deviceState).name();
        StateTraits known = traits.getOrDefault(new State(state), StateTraits.NONE);
        if (known.device() != null && !known.device().equals(device)) {
            problems.add(
                    "state " + state + " has two device states, " + known.device() + " and " + device + "; keep one");
        }
        return traits(state, traits -> traits.withDevice(device));
    }

    /**
     * The same for a state that only stands inside the drawn state with the device state, so that it may be one of the
     * device, see {@link StateMachine#inheritsDeviceState}.
     */
    public StateMachineBuilder inheritedDeviceState(String state, String deviceState) {
        return deviceState(state, deviceState).traits(state, StateTraits::withInherited);
    }

    /** Adds a state with the device state and the sends of a state of another machine. */
    public StateMachineBuilder device(String state, StateMachine other, State same) {
        other.sends(same).forEach(event -> sends(state, event.name()));
        String device = other.deviceState(same);
        if (device == null) {
            return this;
        }
        return other.inheritsDeviceState(same) ? inheritedDeviceState(state, device) : deviceState(state, device);
    }

    /** Adds a state whose function may send {@code event} to the device, see {@link StateMachine#sends}. */
    public StateMachineBuilder sends(String state, String event) {
        Event sent = new Event(event);
        return traits(state, known -> known.withSends(sent));
    }

    private StateMachineBuilder traits(String state, UnaryOperator<StateTraits> change) {
        State owner = new State(state);
        row(owner);
        traits.put(owner, change.apply(traits.getOrDefault(owner, StateTraits.NONE)));
        return this;
    }

    /**
     * Adds a state of a machine that was drawn with states inside others, or with histories.
     *
     * @param withoutMemory see {@link StateMachine#withoutMemory}
     * @param activities see {@link StateMachine#activities}
     * @param paths see {@link StateMachine#paths}
     * @param end see {@link StateMachine#isEnd}
     */
    public StateMachineBuilder drawn(
            State state, State withoutMemory, List<String> activities, List<String> paths, boolean end) {
        row(state);
        requireNonNull(withoutMemory, "the state without memory is null; for most states it is the state itself");
        Names.requireAll(activities, ACTIVITIES);
        Names.requireAll(paths, "the paths of a state are null, or one of them is; its name is its path at the top");
        boolean itself = withoutMemory.equals(state);
        boolean inPlace = paths.size() == 1 && paths.get(0).equals(state.name());
        if (end || !itself || !inPlace || !activities.isEmpty()) {
            traits.put(
                    state,
                    new StateTraits(
                            activities,
                            Set.of(),
                            itself ? null : withoutMemory,
                            inPlace ? List.of() : paths,
                            end,
                            null,
                            false,
                            Set.of()));
        }
        return this;
    }

    /**
     * Adds an event, which need not occur on any transition. Where it occurs only with guards, it is no event besides
     * those.
     */
    public StateMachineBuilder event(String event) {
        return event(drawn(event));
    }

    /** The same for an event as it is. */
    public StateMachineBuilder event(Event event) {
        if (!events.contains(event)) {
            named.add(event);
        }
        addEvent(event, "");
        return this;
    }

    /** Adds an event that the device takes of its own accord. */
    public StateMachineBuilder spontaneous(String event) {
        return spontaneous(unguarded(event));
    }

    /** The same for an event as it is. */
    public StateMachineBuilder spontaneous(Event event) {
        spontaneous.add(event);
        return event(event);
    }

    /** Adds an event that is urgent, see {@link StateMachine#urgent}. */
    public StateMachineBuilder urgent(String event) {
        return urgent(unguarded(event));
    }

    /** The same for an event as it is. */
    public StateMachineBuilder urgent(Event event) {
        urgent.add(event);
        return event(event);
    }

    private Event unguarded(String event) {
        Event drawn = drawn(event);
        if (!drawn.guards().isEmpty()) {
            problems.add("the event " + drawn + " is declared with a guard; write " + drawn.name()
                    + ", which holds for all");
        }
        return drawn.trigger();
    }

    /** Begins a transition that leaves {@code state} and is drawn part by part. */
    public TransitionDraft from(String state) {
        finishDraft();
        draft = new TransitionDraft(this, new State(state));
        return draft;
    }

    private void finishDraft() {
        TransitionDraft finished = draft;
        draft = null;
        if (finished != null && finished.problem().isEmpty()) {
            transition(finished.transition(), "");
        } else if (finished != null) {
            problems.add(finished.problem());
        }
    }

    /**
     * Adds a transition, with its states and event.
     *
     * @param event its name, followed by its guards if it has any, as in {@code press [hot] [full]}
     */
    public StateMachineBuilder transition(String source, String event, String target) {
        return transition(source, event, target, "");
    }

    /**
     * Adds a transition read from a file.
     *
     * @param place its place for messages, such as {@code line 12}; empty if it has none
     */
    public StateMachineBuilder transition(String source, String event, String target, String place) {
        return transition(new Transition(new State(source), drawn(event), new State(target)), place);
    }

    static Event drawn(String event) {
        Matcher guarded = GUARDED.matcher(requireNonNull(event, "the name of an event is null"));
        return guarded.matches()
                ? new Event(
                        guarded.group(1),
                        GUARD.matcher(guarded.group(2))
                                .results()
                                .map(guard -> guard.group(1))
                                .toList())
                : new Event(event);
    }

    /**
     * Adds a transition read from a file, with its guards and effects. Of those of one state with the same trigger, the
     * first added whose guards hold is taken.
     *
     * @param place as above
     */
    public StateMachineBuilder transition(Transition transition, String place) {
        finishDraft();
        Row row = row(requireNonNull(transition, NO_TRANSITION).source());
        row(transition.target());
        add(transition, row, place);
        return this;
    }

    /**
     * Adds the transitions that leave a state, in order. Their states must have been added: this saves a look-up for
     * each end of a hundred thousand transitions.
     */
    public StateMachineBuilder transitions(State source, List<Transition> leaving) {
        finishDraft();
        Row row = row(source);
        for (Transition transition : requireNonNull(leaving, "the transitions that leave a state are null")) {
            add(requireNonNull(transition, NO_TRANSITION), row, "");
        }
        row.close();
        return this;
    }

    private void add(Transition transition, Row row, String place) {
        requireNonNull(place, "the place of a transition is null; \"\" if it has none");
        Event event = transition.event();
        addEvent(event, place);
        named.remove(event);
        Transition present = row.putIfAbsent(transition);
        if (present != null) {
            problems.add("two transitions leave state " + transition.source() + " on event " + event + ": "
                    + placed(present, places.getOrDefault(present, "")) + " and " + placed(transition, place)
                    + "; remove one of them or give it another event");
        } else if (!place.isEmpty()) {
            places.put(transition, place);
        }
    }

    private static String placed(Transition transition, String place) {
        return place.isEmpty() ? transition.toString() : transition + " (" + place + ")";
    }

    private void addEvent(Event event, String place) {
        if (events.add(event)) {
            try {
                event.timeTrigger();
            } catch (ModelException malformed) {
                problems.add(malformed.getMessage() + (place.isEmpty() ? "" : " (" + place + ")"));
            }
        }
    }

    /** The problems that {@link #build()} would report in the transitions added so far. */
    public List<String> problems() {
        finishDraft();
        return List.copyOf(problems);
    }

    /**
     * The machine.
     *
     * @throws ModelException if it has no initial state, is not deterministic, or has a malformed time trigger; the
     *     message lists all problems
     */
    public StateMachine build() {
        finishDraft();
        State start = initial;
        if (start == null) {
            problems.add("no initial state; draw an initial pseudostate with a transition to the first state");
        }
        if (start == null || !problems.isEmpty()) {
            throw new ModelException("state machine '" + name + "': " + String.join("; ", problems));
        }
        built = true;
        return new StateMachine(
                name, start, rows, withoutNamesOfGuarded(), spontaneous, urgent, initialEffects, traits);
    }

    /** The events, without those that are named but drawn only with guards. */
    private Set<Event> withoutNamesOfGuarded() {
        Set<Event> drawn = new LinkedHashSet<>(events);
        for (Event event : events) {
            if (!event.guards().isEmpty() && named.contains(event.trigger())) {
                drawn.remove(event.trigger());
            }
        }
        return drawn;
    }
}
