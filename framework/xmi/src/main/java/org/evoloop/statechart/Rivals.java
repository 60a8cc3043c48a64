package org.evoloop.statechart;

import java.util.HashMap;
import java.util.Map;
import java.util.Set;
import org.jspecify.annotations.Nullable;

/**
 * Which of several transitions leaves a state: two that leave the same one, or one within the other, cannot both be
 * taken.
 *
 * @param <T> a transition
 */
final class Rivals<T> {
    private final Map<Node, T> leaving = new HashMap<>();
    /** Of each state that is left, the states around it and itself. */
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

    /** {@code taken} leaves {@code exited}. */
    void add(T taken, Set<Node> exited) {
        for (Node node : exited) {
            leaving.putIfAbsent(node, taken);
            for (Node outer = node; outer != null; outer = outer.zone.owner) {
                leavingInside.putIfAbsent(outer, taken);
            }
        }
    }
}
