package org.evoloop.statemachine;

import static java.util.Objects.requireNonNull;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.UnaryOperator;
import org.jspecify.annotations.Nullable;

/**
 * A state machine model Sys = (E, S, T) with an initial state (paper, section IV.A): T is a function S x E -> S, so at
 * most one transition leaves a state on an event.
 *
 * <p>Sets keep the order in which the model names their members. Build one with {@link #named(String)}, or read it from
 * a file with {@code org.evoloop.xmi}.
 *
 * <p>Threading: immutable.
 *
 * @since 0.1
 */
public final class StateMachine {
    private final String name;
    private final State initial;
    /** By the states, in their order. */
    private final Map<State, Row> rows;

    private final Set<Event> events;
    private final Set<Event> spontaneous;
    private final Set<Event> urgent;
    private final Set<String> guards;
    private final List<String> initialEffects;
    /** Only for states that have any. */
    private final Map<State, StateTraits> traits;
    /** States that differ only in their memory, by the state without memory; only where there are several. */
    private final Map<State, List<State>> alike;

    /** @param rows kept, and not changed any more */
    StateMachine(
            String name,
            State initial,
            Map<State, Row> rows,
            Set<Event> events,
            Set<Event> spontaneous,
            Set<Event> urgent,
            List<String> initialEffects,
            Map<State, StateTraits> traits) {
        this.name = name;
        this.initial = initial;
        this.rows = rows;
        rows.values().forEach(Row::close);
        this.events = Collections.unmodifiableSet(new LinkedHashSet<>(events));
        this.spontaneous = Collections.unmodifiableSet(new LinkedHashSet<>(spontaneous));
        this.urgent = Collections.unmodifiableSet(new LinkedHashSet<>(urgent));
        this.guards = guardsOf(this.events);
        this.initialEffects = List.copyOf(initialEffects);
        this.traits = Map.copyOf(traits);
        this.alike = findAlike();
    }

    private StateMachine(StateMachine same, String name, Set<Event> urgent, Map<State, StateTraits> traits) {
        this.name = name;
        this.initial = same.initial;
        this.rows = same.rows;
        this.events = same.events;
        this.spontaneous = same.spontaneous;
        this.urgent = urgent;
        this.guards = same.guards;
        this.initialEffects = same.initialEffects;
        this.traits = traits;
        this.alike = same.alike;
    }

    private static Set<String> guardsOf(Set<Event> events) {
        Set<String> guards = new LinkedHashSet<>();
        for (Event event : events) {
            guards.addAll(event.guards());
        }
        return Collections.unmodifiableSet(guards);
    }

    private Map<State, List<State>> findAlike() {
        Map<State, List<State>> found = new HashMap<>();
        traits.forEach((state, own) -> {
            if (own.withoutMemory() != null) {
                found.put(own.withoutMemory(), new ArrayList<>());
            }
        });
        if (!found.isEmpty()) {
            for (State state : rows.keySet()) {
                List<State> several = found.get(withoutMemory(state));
                if (several != null) {
                    several.add(state);
                }
            }
            found.replaceAll((state, several) -> List.copyOf(several));
        }
        return found;
    }

    /**
     * A copy with this name.
     *
     * @throws NullPointerException if it is null
     */
    public StateMachine withName(String otherName) {
        return new StateMachine(this, requireNonNull(otherName, "the name of a state machine is null"), urgent, traits);
    }

    /** A copy in which {@code state} has this {@linkplain #deviceState device state}. */
    public StateMachine withDeviceState(State state, String device) {
        String valid = new State(device).name();
        return with(state, known -> known.withDevice(valid));
    }

    /** A copy in which the function of {@code state} may {@linkplain #sends send} this event, too. */
    public StateMachine withSends(State state, Event event) {
        requireNonNull(event, "the event that a function sends is null");
        return with(state, known -> known.withSends(event));
    }

    /** A copy in which nothing is {@linkplain #urgent urgent}. */
    public StateMachine withoutUrgent() {
        return new StateMachine(this, name, Set.of(), traits);
    }

    private StateMachine with(State state, UnaryOperator<StateTraits> change) {
        Map<State, StateTraits> changed = new HashMap<>(traits);
        changed.put(state, change.apply(traitsOf(state)));
        return new StateMachine(this, name, urgent, Map.copyOf(changed));
    }

    /** A copy in which {@code event} is {@linkplain #urgent urgent}, too. */
    public StateMachine withUrgent(Event event) {
        Set<Event> all = new LinkedHashSet<>(urgent);
        all.add(requireNonNull(event, "the event that is urgent is null").trigger());
        return new StateMachine(this, name, Collections.unmodifiableSet(all), traits);
    }

    /**
     * A copy with other names for some of its states.
     *
     * @param names the new names by state, including states {@linkplain #withoutMemory without memory}
     * @throws NullPointerException if {@code names} or one of the new names is null
     * @throws ModelException if two states would have the same name, or one would have none
     */
    public StateMachine withStateNames(Map<State, String> names) {
        requireNonNull(names, "the new names of states are null; Map.of() are none");
        UnaryOperator<State> renamed = state -> names.containsKey(state) ? new State(names.get(state)) : state;
        StateMachineBuilder builder = new StateMachineBuilder(name);
        Set<State> all = new LinkedHashSet<>();
        for (State state : rows.keySet()) {
            State same = renamed.apply(state);
            if (!all.add(same)) {
                throw new ModelException("state machine '" + name + "' has two states named " + same + "; rename one");
            }
            builder.drawn(same, renamed.apply(withoutMemory(state)), activities(state), paths(state), isEnd(state));
            deferred(state).forEach(event -> builder.defers(same.name(), event));
            builder.device(same.name(), this, state);
        }
        builder.initial(renamed.apply(initial).name()).initialEffects(initialEffects);
        events.forEach(builder::event);
        spontaneous.forEach(builder::spontaneous);
        urgent.forEach(builder::urgent);
        for (Transition transition : transitions()) {
            builder.transition(
                    new Transition(
                            renamed.apply(transition.source()),
                            transition.event(),
                            renamed.apply(transition.target()),
                            transition.effects(),
                            transition.internal(),
                            transition.keeps()),
                    "");
        }
        return builder.build();
    }

    /**
     * Starts a machine of this name, which is used in messages.
     *
     * @throws NullPointerException if it is null
     */
    public static StateMachineBuilder named(String name) {
        return new StateMachineBuilder(name);
    }

    /** The name of this machine in messages; the diagram name when it was read from a file. */
    public String name() {
        return name;
    }

    /** The state in which the machine starts; a member of {@link #states()}. */
    public State initial() {
        return initial;
    }

    /** Names of the behaviors that run when the machine starts, in order. */
    public List<String> initialEffects() {
        return initialEffects;
    }

    /** The timer events of {@code state}, without guards, and their delays, as drawn. */
    public Map<Event, Duration> timers(State state) {
        Map<Event, Duration> timers = new LinkedHashMap<>();
        for (Transition transition : transitionsFrom(state)) {
            Event trigger = transition.event().trigger();
            trigger.timeTrigger().ifPresent(delay -> timers.put(trigger, delay));
        }
        return timers;
    }

    /** Names of the behaviors that run while {@code state} lasts (UML's do activities), outer ones first. */
    public List<String> activities(State state) {
        return traitsOf(state).activities();
    }

    /**
     * The events that {@code state} defers where none of its transitions applies, in order; with guards where they are
     * deferred only under those.
     */
    public Set<Event> deferred(State state) {
        return traitsOf(state).deferred();
    }

    /**
     * Whether {@code state} defers {@code event}, so that it waits for a state that does not. A transition that applies
     * takes precedence.
     *
     * @param event the event with the guards under which it comes; without guards if none of those drawn for it hold
     */
    public boolean defers(State state, Event event) {
        Set<Event> waiting = traitsOf(state).deferred();
        return !waiting.isEmpty()
                && (waiting.contains(event) || (find(state, event) == null && waiting.contains(event.trigger())));
    }

    /** Whether any state defers {@code event}, be it under guards only. */
    public boolean mayDefer(Event event) {
        return traits.values().stream()
                .flatMap(state -> state.deferred().stream())
                .anyMatch(deferred -> deferred.trigger().equals(event.trigger()));
    }

    /**
     * The state of the original model in which the device must be while {@code state}, a new one, lasts; null if the
     * device may be anywhere. As it was written: a name or a path, which a pair of models resolves.
     */
    public @Nullable String deviceState(State state) {
        return traitsOf(state).device();
    }

    /**
     * Whether the {@linkplain #deviceState device state} is that of a drawn state around {@code state}. It then means
     * nothing in a state that the device has itself, whose own device state would be an error.
     */
    public boolean inheritsDeviceState(State state) {
        return traitsOf(state).inherited();
    }

    /** The events that the function of {@code state} may send to the device, in order. */
    public Set<Event> sends(State state) {
        return traitsOf(state).sends();
    }

    private StateTraits traitsOf(State state) {
        return traits.getOrDefault(requireNonNull(state, "the state is null"), StateTraits.NONE);
    }

    /**
     * {@code state} without what the machine remembers in it: which state a history restores, or that an activity has
     * ended. {@code Off} for {@code Off [history Dim]}; for most states, the state itself. It need not be one of {@link
     * #states()}; it is the state as drawn.
     */
    public State withoutMemory(State state) {
        State plain = traitsOf(state).withoutMemory();
        return plain == null ? state : plain;
    }

    /**
     * The states of this machine that differ from {@code state} at most in what the machine remembers, including
     * itself, in order.
     *
     * @param state with its memory or without, see {@link #withoutMemory}
     * @return empty if this machine has none
     */
    public List<State> alike(State state) {
        List<State> several = alike.isEmpty() ? null : alike.get(withoutMemory(state));
        if (several != null) {
            return several;
        }
        Row row = rows.get(state);
        return row == null ? List.of() : row.alone();
    }

    /** Whether any state differs from {@code state} at most in what the machine remembers, see {@link #alike}. */
    public boolean hasAlike(State state) {
        return hasState(state) || alike.containsKey(withoutMemory(state));
    }

    /**
     * Where {@code state} is drawn: the path {@code Outer.Inner} of the innermost active state, one for each region of
     * orthogonal regions. Its name where nothing else is known.
     */
    public List<String> paths(State state) {
        List<String> known = traitsOf(state).paths();
        return known.isEmpty() ? List.of(state.name()) : known;
    }

    /** Whether every state is drawn at the top level, inside no other and without memory. */
    public boolean isDrawnFlat() {
        return traits.values().stream().allMatch(some -> some.paths().isEmpty() && some.withoutMemory() == null);
    }

    /** Whether the machine ends in {@code state}: only final states, or a terminate pseudostate. */
    public boolean isEnd(State state) {
        return traitsOf(state).end();
    }

    /** S, never empty. */
    public Set<State> states() {
        return Collections.unmodifiableSet(rows.keySet());
    }

    /** E. */
    public Set<Event> events() {
        return events;
    }

    /**
     * E without guards: the events that a monitor can report or that can be sent. The same as {@link #events()} where
     * no guard is drawn.
     */
    public Set<Event> triggers() {
        Set<Event> triggers = new LinkedHashSet<>();
        for (Event event : events) {
            triggers.add(event.trigger());
        }
        return Collections.unmodifiableSet(triggers);
    }

    /** Those of the {@link #triggers()} that the model itself declares to be the device's own. */
    public Set<Event> spontaneous() {
        return spontaneous;
    }

    /**
     * Those of the {@link #triggers()} that are urgent: each has a place in the queue that no other can take, has its
     * turn before all other requests, and ends the plan in progress between two steps.
     */
    public Set<Event> urgent() {
        return urgent;
    }

    /** The texts of all guards. */
    public Set<String> guards() {
        return guards;
    }

    /** T, ordered by source state. */
    public List<Transition> transitions() {
        List<Transition> all = new ArrayList<>();
        for (Row row : rows.values()) {
            all.addAll(row.transitions());
        }
        return Collections.unmodifiableList(all);
    }

    /** The transitions that leave {@code source}; empty for a state that is not of this machine. */
    public List<Transition> transitionsFrom(State source) {
        Row row = rows.get(source);
        return row == null ? List.of() : row.transitions();
    }

    /** Whether {@code state} is a member of S (the paper's {@code existState}). */
    public boolean hasState(State state) {
        return rows.containsKey(state);
    }

    /** Whether {@code event} is acceptable in {@code source} (the paper's {@code existTransition}). */
    public boolean hasTransition(State source, Event event) {
        return find(source, event) != null;
    }

    /** Whether {@code trigger} is acceptable in {@code source}, even if only under a guard. */
    public boolean hasTrigger(State source, Event trigger) {
        for (Transition transition : transitionsFrom(source)) {
            if (transition.event().name().equals(trigger.name())) {
                return true;
            }
        }
        return false;
    }

    /** The transition that {@code event} triggers in {@code source} (the paper's {@code getTransition}). */
    public Optional<Transition> transition(State source, Event event) {
        return Optional.ofNullable(find(source, event));
    }

    /** The state to which {@code event} leads from {@code source} (the paper's {@code getNextState}). */
    public Optional<State> nextState(State source, Event event) {
        Transition transition = find(source, event);
        return transition == null ? Optional.empty() : Optional.of(transition.target());
    }

    private @Nullable Transition find(State source, Event event) {
        Row row = rows.get(source);
        return row == null ? null : row.find(event);
    }

    /** For messages: the name and the sizes of S, E and T. */
    @Override
    public String toString() {
        return name + " (" + rows.size() + " states, " + events.size() + " events, "
                + transitions().size() + " transitions)";
    }
}
