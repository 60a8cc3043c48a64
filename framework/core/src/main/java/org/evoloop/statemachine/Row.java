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
    /** Whether the list can be modified. */
    private boolean open;
    /** Null while there are few. */
    private @Nullable Map<Event, Transition> byEvent;

    Row(State state) {
        this.alone = List.of(state);
    }

    /** A copy of {@code same}, which is closed. */
    Row(Row same) {
        this.alone = same.alone;
        this.transitions = same.transitions;
        this.byEvent = same.byEvent == null ? null : new HashMap<>(same.byEvent);
    }

    /** Makes its list unmodifiable, until a transition is added. */
    void close() {
        if (open) {
            transitions = List.copyOf(transitions);
            open = false;
        }
    }

    /** Adds a transition unless there is one on its event; returns that one, else null. */
    @Nullable
    Transition putIfAbsent(Transition transition) {
        Transition present = find(transition.event());
        if (present == null) {
            if (!open) {
                List<Transition> before = transitions;
                transitions = new ArrayList<>(before.size() + FEW);
                transitions.addAll(before);
                open = true;
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
