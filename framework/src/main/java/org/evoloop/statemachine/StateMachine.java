package org.evoloop.statemachine;

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
 */
public final class StateMachine {
    private final String name;
    private final State initial;
    private final Set<State> states;
    private final Set<Event> events;
    private final Map<State, List<Transition>> outgoing;
    private final Map<State, Map<Event, Transition>> byEvent;
    private final List<String> initialEffects;
    private final Map<State, List<String>> activities;
    /** Only of states that are drawn inside others, or ends. */
    private final Map<State, DrawnState> drawn;

    StateMachine(
            String name,
            State initial,
            Set<State> states,
            Set<Event> events,
            Map<State, Map<Event, Transition>> outgoing,
            List<String> initialEffects,
            Map<State, List<String>> activities,
            Map<State, DrawnState> drawn) {
        this.name = name;
        this.initial = initial;
        this.states = Collections.unmodifiableSet(new LinkedHashSet<>(states));
        this.events = Collections.unmodifiableSet(new LinkedHashSet<>(events));
        this.outgoing = new LinkedHashMap<>();
        this.byEvent = new HashMap<>();
        for (Map.Entry<State, Map<Event, Transition>> row : outgoing.entrySet()) {
            this.outgoing.put(row.getKey(), List.copyOf(row.getValue().values()));
            this.byEvent.put(row.getKey(), Map.copyOf(row.getValue()));
        }
        this.initialEffects = List.copyOf(initialEffects);
        this.activities = Map.copyOf(activities);
        this.drawn = Map.copyOf(drawn);
    }

    private StateMachine(StateMachine same, String name) {
        this.name = name;
        this.initial = same.initial;
        this.states = same.states;
        this.events = same.events;
        this.outgoing = same.outgoing;
        this.byEvent = same.byEvent;
        this.initialEffects = same.initialEffects;
        this.activities = same.activities;
        this.drawn = same.drawn;
    }

    /** The same machine, which messages call {@code otherName}. */
    public StateMachine withName(String otherName) {
        return new StateMachine(this, otherName);
    }

    /** The same machine with other names for some of its states. @throws ModelException if two would have one name */
    public StateMachine withStateNames(Map<State, String> names) {
        UnaryOperator<State> renamed = state -> names.containsKey(state) ? new State(names.get(state)) : state;
        StateMachineBuilder builder = new StateMachineBuilder(name);
        Set<State> all = new LinkedHashSet<>();
        for (State state : states) {
            State same = renamed.apply(state);
            if (!all.add(same)) {
                throw new ModelException("state machine '" + name + "' has two states named " + same + "; rename one");
            }
            builder.activities(same.name(), activities(state)).drawn(same.name(), paths(state), isEnd(state));
        }
        builder.initial(renamed.apply(initial).name()).initialEffects(initialEffects);
        events.forEach(builder::event);
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

    /** Starts a machine of this name; the name is what messages call it. */
    public static StateMachineBuilder named(String name) {
        return new StateMachineBuilder(name);
    }

    /** What messages call this machine; the diagram name when it was read from a file. */
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

    /** Names of the behaviors that go on while {@code state} lasts (UML's do activities), outer ones first. */
    public List<String> activities(State state) {
        return activities.getOrDefault(state, List.of());
    }

    /**
     * Where {@code state} is drawn: the path {@code Outer.Inner} of the innermost state that is active in it, of regions
     * side by side one for each. Its name where nothing else is known.
     */
    public List<String> paths(State state) {
        DrawnState known = drawn.get(state);
        return known == null ? List.of(state.name()) : known.paths();
    }

    /** Whether {@code state} is where the machine ends: nothing but final states, or a terminate pseudostate. */
    public boolean isEnd(State state) {
        DrawnState known = drawn.get(state);
        return known != null && known.end();
    }

    /** S, never empty. */
    public Set<State> states() {
        return states;
    }

    /** E. */
    public Set<Event> events() {
        return events;
    }

    /** E without guards: what can be told by a monitor or sent. The same as {@link #events()} where no guard is drawn. */
    public Set<Event> triggers() {
        Set<Event> triggers = new LinkedHashSet<>();
        for (Event event : events) {
            triggers.add(event.trigger());
        }
        return Collections.unmodifiableSet(triggers);
    }

    /** The texts of all guards. */
    public Set<String> guards() {
        Set<String> guards = new LinkedHashSet<>();
        for (Event event : events) {
            guards.addAll(event.guards());
        }
        return Collections.unmodifiableSet(guards);
    }

    /** T, ordered by source state. */
    public List<Transition> transitions() {
        List<Transition> all = new ArrayList<>();
        for (List<Transition> some : outgoing.values()) {
            all.addAll(some);
        }
        return Collections.unmodifiableList(all);
    }

    /** The transitions that leave {@code source}; empty for a state that is not of this machine. */
    public List<Transition> transitionsFrom(State source) {
        return outgoing.getOrDefault(source, List.of());
    }

    /** Whether {@code state} is a member of S (the paper's {@code existState}). */
    public boolean hasState(State state) {
        return states.contains(state);
    }

    /** Whether {@code event} is acceptable in {@code source} (the paper's {@code existTransition}). */
    public boolean hasTransition(State source, Event event) {
        return find(source, event) != null;
    }

    /** Whether {@code trigger} is acceptable in {@code source}, be it under a guard. */
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

    /** Where {@code event} leads from {@code source} (the paper's {@code getNextState}). */
    public Optional<State> nextState(State source, Event event) {
        Transition transition = find(source, event);
        return transition == null ? Optional.empty() : Optional.of(transition.target());
    }

    private @Nullable Transition find(State source, Event event) {
        Map<Event, Transition> row = byEvent.get(source);
        return row == null ? null : row.get(event);
    }

    /** For messages: the name and the sizes of S, E and T. */
    @Override
    public String toString() {
        return name + " (" + states.size() + " states, " + events.size() + " events, "
                + transitions().size() + " transitions)";
    }
}
