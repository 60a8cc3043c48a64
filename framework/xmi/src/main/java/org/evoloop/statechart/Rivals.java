package org.evoloop.statechart;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/**
 * The transitions that one event enables, by number in document order. Two that leave the same state, or states of which
 * one contains the other, cannot both be taken. If one of them has a guard, the first is taken, since the author has
 * looked at both; otherwise UML leaves open which.
 */
final class Rivals {
    /** Enough to find a difference: charts with more have one already among these. */
    private static final int MAX_CHOICES = 256;

    /** By transition, the outermost states that it leaves. */
    private final List<Set<Node>> exited;

    private final List<Boolean> guarded;

    Rivals(List<Set<Node>> exited, List<Boolean> guarded) {
        this.exited = exited;
        this.guarded = guarded;
    }

    /** Whether the transition leaves a state. */
    boolean leaves(int number, Node state) {
        return exited.get(number).stream().anyMatch(left -> left.holds(state));
    }

    /** The sets of transitions that may be taken together, the one that prefers the first transitions first. */
    List<List<Integer>> choices() {
        List<List<Integer>> choices = new ArrayList<>();
        choose(0, List.of(), new HashSet<>(), choices);
        return choices;
    }

    private void choose(int next, List<Integer> kept, Set<Integer> passed, List<List<Integer>> choices) {
        if (choices.size() >= MAX_CHOICES) {
            return;
        }
        if (next == exited.size()) {
            // One that is passed over must have lost against another.
            if (passed.stream().allMatch(one -> kept.stream().anyMatch(other -> isOpen(one, other)))) {
                choices.add(kept);
            }
            return;
        }
        if (kept.stream().anyMatch(other -> conflict(next, other))) {
            choose(next + 1, kept, passed, choices);
            return;
        }
        List<Integer> with = new ArrayList<>(kept);
        with.add(next);
        choose(next + 1, with, passed, choices);
        for (int later = next + 1; later < exited.size(); later++) {
            if (isOpen(next, later)) {
                Set<Integer> without = new HashSet<>(passed);
                without.add(next);
                choose(next + 1, kept, without, choices);
                return;
            }
        }
    }

    /** Two transitions of which either may be taken. */
    int[] undecided() {
        for (int other = 1; other < exited.size(); other++) {
            for (int one = 0; one < other; one++) {
                if (isOpen(one, other)) {
                    return new int[] {one, other};
                }
            }
        }
        throw new IllegalStateException("every choice is decided");
    }

    private boolean isOpen(int one, int other) {
        return !guarded.get(one) && !guarded.get(other) && conflict(one, other);
    }

    private boolean conflict(int one, int other) {
        return exited.get(one).stream()
                .anyMatch(left -> exited.get(other).stream().anyMatch(node -> left.holds(node) || node.holds(left)));
    }
}
