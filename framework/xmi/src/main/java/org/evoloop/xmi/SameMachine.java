package org.evoloop.xmi;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.evoloop.statemachine.Names;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.Transition;

/** Compares flat machines in everything by which a converter could tell them apart. */
final class SameMachine {
    private SameMachine() {}

    /** What differs, beginning with what the first machine has; empty if nothing does. */
    static Optional<String> difference(StateMachine one, StateMachine other) {
        return differs("its name is", one.name(), other.name())
                .or(() -> differs("it has the states", one.states(), other.states()))
                .or(() -> differs("it starts in", one.initial(), other.initial()))
                .or(() -> differs("its first effects are", one.initialEffects(), other.initialEffects()))
                .or(() -> differs("it has the events", one.events(), other.events()))
                .or(() -> differs("its spontaneous events are", one.spontaneous(), other.spontaneous()))
                .or(() -> differs("its urgent events are", one.urgent(), other.urgent()))
                .or(() -> one.states().stream()
                        .flatMap(state -> difference(state, one, other).stream())
                        .findFirst());
    }

    private static Optional<String> difference(State state, StateMachine one, StateMachine other) {
        return differs(state + " does", one.activities(state), other.activities(state))
                .or(() -> differs(state + " defers", one.deferred(state), other.deferred(state)))
                .or(() -> differs(
                        state + " has the device in",
                        String.valueOf(one.deviceState(state)),
                        String.valueOf(other.deviceState(state))))
                .or(() -> differs(
                        state + " has the device state of a state around it:",
                        one.inheritsDeviceState(state),
                        other.inheritsDeviceState(state)))
                .or(() -> differs(state + " sends", one.sends(state), other.sends(state)))
                .or(() -> differs(state + " without memory is", one.withoutMemory(state), other.withoutMemory(state)))
                .or(() -> differs("from " + state + " lead", transitions(one, state), transitions(other, state)));
    }

    /** Those on the same event in their order, which decides which is taken. */
    private static List<String> transitions(StateMachine machine, State state) {
        List<Transition> all = new ArrayList<>(machine.transitionsFrom(state));
        all.sort(Comparator.comparing(transition -> transition.event().name()));
        return all.stream()
                .map(transition -> transition
                        + (transition.effects().isEmpty() ? "" : " / " + String.join("; ", transition.effects()))
                        + (transition.internal() ? " (internal)" : "")
                        + (transition.keeps().isEmpty()
                                ? ""
                                : " keeping "
                                        + transition.keeps().stream().sorted().toList()))
                .toList();
    }

    private static Optional<String> differs(String what, Object one, Object other) {
        if (one.equals(other)) {
            return Optional.empty();
        }
        if (one instanceof List<?> some && other instanceof List<?> others) {
            return Optional.of(
                    Names.inOneLine(what + " " + without(some, others) + ", and it would be " + without(others, some)));
        }
        return one instanceof Set<?> some && other instanceof Set<?> others
                ? Optional.of(Names.inOneLine(
                        what + " " + without(some, others) + ", and it would have " + without(others, some)))
                : Optional.of(Names.inOneLine(what + " " + one + ", and it would be " + other));
    }

    /** The elements that the other collection lacks, in order; all of them if only the order differs. */
    private static String without(Iterable<?> some, Collection<?> others) {
        Set<Object> known = new HashSet<>(others);
        List<String> only = new ArrayList<>();
        List<String> all = new ArrayList<>();
        for (Object element : some) {
            all.add(String.valueOf(element));
            if (!known.contains(element)) {
                only.add(String.valueOf(element));
            }
        }
        List<String> shown = only.isEmpty() ? all : only;
        return shown.isEmpty() ? "none" : String.join(", ", shown.subList(0, Math.min(3, shown.size())));
    }
}
