package org.evoloop.statemachine;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/**
 * The transitions that leave one state, in order, at most one on an event.
 *
 * <p>Threading: not thread-safe while it is written, thread-safe afterwards.
 */
final class Row {
    /** Up to this many are searched faster than hashed, and most states have no more. */
    private static final int FEW = 8;

    private final List<State> alone;
    private List<Transition> transitions = List.of();
    /** Null while there are few. */
    private @Nullable Map<Event, Transition> byEvent;

    Row(State state) {
        this.alone = List.of(state);
    }

    /** A copy of {@code same} to which transitions can be added. */
    Row(Row same) {
        this.alone = same.alone;
        this.transitions = same.transitions.isEmpty() ? List.of() : new ArrayList<>(same.transitions);
        this.byEvent = same.byEvent == null ? null : new HashMap<>(same.byEvent);
    }

    /** Makes its list unmodifiable; nothing can be added any more. */
    void close() {
        transitions = List.copyOf(transitions);
    }

    /** Adds a transition unless there is one on its event; returns that one, else null. */
    @Nullable
    Transition putIfAbsent(Transition transition) {
        Transition present = find(transition.event());
        if (present == null) {
            if (transitions.isEmpty()) {
                transitions = new ArrayList<>(FEW);
            }
            transitions.add(transition);
            if (byEvent != null) {
                byEvent.put(transition.event(), transition);
            } else if (transitions.size() > FEW) {
                byEvent = new HashMap<>();
                for (Transition each : transitions) {
                    byEvent.put(each.event(), each);
                }
            }
        }
        return present;
    }

    /** The transition on an event; null if there is none. */
    @Nullable
    Transition find(Event event) {
        if (byEvent != null) {
            return byEvent.get(event);
        }
        for (int index = 0; index < transitions.size(); index++) {
            Transition transition = transitions.get(index);
            if (transition.event().equals(event)) {
                return transition;
            }
        }
        return null;
    }

    /** A list of only this state, as the machine names it. */
    List<State> alone() {
        return alone;
    }

    /** All transitions; unmodifiable once it is closed. */
    List<Transition> transitions() {
        return transitions;
    }
}
