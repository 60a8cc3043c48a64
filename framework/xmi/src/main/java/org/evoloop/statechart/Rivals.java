package org.evoloop.statechart;

import java.util.HashMap;
import java.util.Map;
import java.util.Set;
import org.jspecify.annotations.Nullable;

/**
 * Detects conflicting transitions: two that leave the same state, or states of which one contains the other, cannot
 * both be taken.
 *
 * @param <T> a transition
 */
final class Rivals<T> {
    private final Map<Node, T> leaving = new HashMap<>();
    /** For each state that is left, that state and the states around it. */
    private final Map<Node, T> leavingInside = new HashMap<>();

    /** A transition that cannot be taken together with one that leaves {@code exited}; null if there is none. */
    @Nullable
    T rivalOf(Set<Node> exited) {
        for (Node node : exited) {
            T inside = leavingInside.get(node);
            if (inside != null) {
                return inside;
            }
            for (Node outer = node; outer != null; outer = outer.zone.owner) {
                T around = leaving.get(outer);
                if (around != null) {
                    return around;
                }
            }
        }
        return null;
    }

    /** Adds a transition that leaves {@code exited}. */
    void add(T taken, Set<Node> exited) {
        for (Node node : exited) {
            leaving.putIfAbsent(node, taken);
            for (Node outer = node; outer != null; outer = outer.zone.owner) {
                leavingInside.putIfAbsent(outer, taken);
            }
        }
    }
}
