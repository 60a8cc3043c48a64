package org.evoloop.models.flat;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.evoloop.statechart.DeviceUse;
import org.evoloop.statechart.EventKeywords;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.Names;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.Transition;

/**
 * Writes a flat machine in the dialect of Astah (XMI 1.1 of UML 1.4). Reading the file gives the same machine.
 *
 * <p>In UML a transition has one guard. Several guards become a chain of transitions with junctions between them.
 */
public final class AstahWriter {
    private static final String MACHINE = "machine";
    private static final String INITIAL = "initial";

    private final StateMachine machine;
    private final List<Transition> transitions;
    private final AstahElements xml = new AstahElements();
    private final Map<State, String> ids = new HashMap<>();

    private AstahWriter(StateMachine machine) {
        this.machine = machine;
        this.transitions = machine.transitions();
        machine.states().forEach(state -> ids.put(state, "s" + ids.size()));
    }

    /**
     * What the document cannot express, one line each: {@link FlatLosses}, and line breaks, which Astah's files have only
     * where a name is too long for one line.
     */
    public static List<String> losses(StateMachine machine) {
        List<String> losses = new ArrayList<>(FlatLosses.of(machine));
        texts(machine)
                .filter(text -> !Names.inOneLine(text).equals(text))
                .distinct()
                .forEach(text -> losses.add("the line breaks in '" + Names.inOneLine(text) + "' become spaces"));
        return losses;
    }

    private static Stream<String> texts(StateMachine machine) {
        Stream<String> ofStates = machine.states().stream()
                .flatMap(state -> Stream.concat(Stream.of(state.name()), machine.activities(state).stream()));
        Stream<String> ofTransitions = machine.transitions().stream()
                .flatMap(transition -> Stream.of(
                                List.of(transition.event().name()),
                                transition.event().guards(),
                                transition.effects())
                        .flatMap(List::stream));
        return Stream.concat(machine.initialEffects().stream(), Stream.concat(ofStates, ofTransitions));
    }

    /** The XML text of {@code machine}. */
    public static String write(StateMachine machine) {
        return new AstahWriter(machine).document();
    }

    private String document() {
        xml.head();
        xml.open("StateMachine", MACHINE, machine.name());
        xml.open("StateMachine.top").open("CompositeState", "top", "").open("CompositeState.subvertex");
        xml.pseudostate(INITIAL, "initial");
        machine.states().forEach(this::state);
        for (int number = 0; number < transitions.size(); number++) {
            for (int guard = 1; guard < transitions.get(number).event().guards().size(); guard++) {
                xml.pseudostate(junction(number, guard), "junction");
            }
        }
        xml.close(3);
        xml.open("StateMachine.transitions");
        xml.transition("start", INITIAL, id(machine.initial()), "", "", machine.initialEffects());
        for (int number = 0; number < transitions.size(); number++) {
            if (!transitions.get(number).internal()) {
                transition(number);
            }
        }
        xml.close(2);
        return xml.foot(MACHINE, machine.name());
    }

    private void state(State state) {
        xml.open("CompositeState", id(state), DeviceUse.of(machine, state).mark(state.name()));
        xml.actions("State.doActivity", id(state) + "-do", machine.activities(state));
        xml.deferrable(id(state) + "-later", plainlyDeferred(state));
        for (int number = 0; number < transitions.size(); number++) {
            Transition transition = transitions.get(number);
            if (transition.internal() && transition.source().equals(state)) {
                xml.open("State.internalTransition");
                // An internal transition cannot have junctions.
                String guard = String.join(" and ", transition.event().guards());
                String id = id(state);
                xml.transition("t" + number, id, id, trigger(transition), guard, transition.effects());
                xml.close(1);
            }
        }
        xml.close(1);
    }

    private List<String> plainlyDeferred(State state) {
        return machine.deferred(state).stream()
                .filter(event -> event.guards().isEmpty())
                .map(Event::name)
                .toList();
    }

    private void transition(int number) {
        Transition transition = transitions.get(number);
        List<String> guards = transition.event().guards();
        int last = Math.max(guards.size() - 1, 0);
        for (int segment = 0; segment <= last; segment++) {
            xml.transition(
                    "t" + number + "-" + segment,
                    segment == 0 ? id(transition.source()) : junction(number, segment),
                    segment == last ? id(transition.target()) : junction(number, segment + 1),
                    segment == 0 ? trigger(transition) : "",
                    guards.isEmpty() ? "" : guards.get(segment),
                    segment == last ? transition.effects() : List.of());
        }
    }

    private String trigger(Transition transition) {
        return EventKeywords.drawn(machine, transition.event().trigger());
    }

    private static String junction(int number, int guard) {
        return "j" + number + "-" + guard;
    }

    private String id(State state) {
        return ids.getOrDefault(state, "");
    }
}
