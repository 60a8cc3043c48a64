package org.evoloop.study.proof;

import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.evoloop.engine.Rules;
import org.evoloop.engine.Swap;
import org.evoloop.evolution.DecisionTable;
import org.evoloop.evolution.DeviceEvents;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Timers;
import org.evoloop.migration.Mapping;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.xmi.ModelReference;

/**
 * A pair of models that may be swapped for another one of the same device, and back; with numbers, from 1, for states
 * and events of all of them.
 *
 * <p>Threading: immutable.
 *
 * @param deviceStates of the original model
 * @param systemStates of both new models
 * @param pressed the events of controllers: those that can be sent, and others that are pressed
 */
record EvolvingPair(
        Rules rules,
        Rules next,
        Mapping mapping,
        List<State> deviceStates,
        List<State> systemStates,
        List<Event> events,
        Set<Event> sendable,
        Set<Event> pressed,
        Set<Event> own,
        Set<Event> raised) {

    /** What is known of a device and of its evolution besides the models. */
    record Facts(
            Set<String> sendable,
            Set<String> pressed,
            Set<String> spontaneous,
            Map<String, String> timers,
            int queueCapacity) {}

    /**
     * @param original what the device does, and the others the new models: {@code FILE#NAME}
     * @param mapping as {@link Mapping#parse} reads it
     */
    static EvolvingPair of(String original, String evolved, String next, String mapping, Facts facts) {
        ModelPair pair = new ModelPair(machine(original), machine(evolved));
        ModelPair other = new ModelPair(pair.original(), machine(next));
        Rules rules = rules(pair, facts);
        Rules nextRules = rules(other, facts);
        Set<State> system = new LinkedHashSet<>(pair.evolved().states());
        system.addAll(other.evolved().states());
        Set<Event> events = new LinkedHashSet<>(pair.original().triggers());
        Set<Event> raised = new LinkedHashSet<>(pair.evolved().triggers());
        raised.addAll(other.evolved().triggers());
        raised.removeAll(events);
        events.addAll(raised);
        Set<Event> pressed = new LinkedHashSet<>(events(facts.sendable()));
        pressed.addAll(events(facts.pressed()));
        raised.removeAll(pressed);
        Set<Event> own = events(facts.spontaneous());
        return new EvolvingPair(
                rules,
                nextRules,
                Mapping.parse("the mapping", mapping, pair, other),
                List.copyOf(pair.original().states()),
                List.copyOf(system),
                List.copyOf(events),
                events(facts.sendable()),
                pressed,
                own,
                raised);
    }

    private static StateMachine machine(String reference) {
        return ModelReference.parse(reference).find().toStateMachine();
    }

    private static Rules rules(ModelPair pair, Facts facts) {
        pair.requireValid();
        DeviceEvents device = new DeviceEvents(events(facts.sendable()), events(facts.spontaneous()));
        Timers drawn = Timers.drawnIn(pair.evolved());
        Timers timers = state -> {
            Map<Event, Duration> all = new LinkedHashMap<>(drawn.of(state));
            String coded = facts.timers().get(state.name());
            if (coded != null) {
                all.put(new Event(coded), Duration.ofSeconds(2));
            }
            return all;
        };
        return new Rules(DecisionTable.compile(pair, device), timers, facts.queueCapacity());
    }

    private static Set<Event> events(Set<String> names) {
        Set<Event> events = new LinkedHashSet<>();
        names.forEach(name -> events.add(new Event(name)));
        return events;
    }

    /** By what a core goes; {@code swapped} if the other models count. */
    Rules rules(boolean swapped) {
        return swapped ? next : rules;
    }

    /** To the other models, or back. */
    Swap swap(boolean back) {
        return back ? Swap.of(next, rules, mapping.reversed()) : Swap.of(rules, next, mapping);
    }

    /** The timer of a state; {@link #number} of it is 0 if there is none. */
    List<Event> timer(boolean swapped, State state) {
        return new ArrayList<>(rules(swapped).timers().of(state).keySet());
    }

    int number(State state, boolean ofDevice) {
        return 1 + (ofDevice ? deviceStates : systemStates).indexOf(state);
    }

    int number(Event event) {
        return 1 + events.indexOf(event);
    }
}
