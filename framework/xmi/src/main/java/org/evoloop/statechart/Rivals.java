package org.evoloop.statechart;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.jspecify.annotations.Nullable;

/**
 * The transitions that one event enables, by number in document order. Two that leave the same state, or states of which
 * one contains the other, cannot both be taken; nor can an internal transition and one that leaves its state (UML 2.5.1,
 * 14.2.3.9.3). If one of them has a guard, the first is taken, since the author has
 * looked at both; otherwise UML leaves open which.
 */
final class Rivals {
    /** Enough to find a difference: charts with more have one already among these. */
    private static final int MAX_CHOICES = 256;

    private final List<Rival> rivals;

    Rivals(List<Rival> rivals) {
        this.rivals = rivals;
    }

    /**
     * A transition.
     *
     * @param exited the outermost states that it leaves
     * @param inside the state in which it is internal; null for others
     */
    record Rival(Set<Node> exited, @Nullable Node inside, boolean guarded) {
        /** Whether both leave a state, or one leaves the state in which the other is internal. */
        boolean conflicts(Rival other) {
            return leaves(other.inside)
                    || other.leaves(inside)
                    || exited.stream().anyMatch(other::leaves)
                    || other.exited.stream().anyMatch(this::leaves);
        }

        private boolean leaves(@Nullable Node state) {
            return state != null && exited.stream().anyMatch(left -> left.holds(state));
        }
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
        if (next == rivals.size()) {
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
        for (int later = next + 1; later < rivals.size(); later++) {
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
        for (int other = 1; other < rivals.size(); other++) {
            for (int one = 0; one < other; one++) {
                if (isOpen(one, other)) {
                    return new int[] {one, other};
                }
            }
        }
        throw new IllegalStateException("every choice is decided");
    }

    private boolean isOpen(int one, int other) {
        return !rivals.get(one).guarded() && !rivals.get(other).guarded() && conflict(one, other);
    }

    private boolean conflict(int one, int other) {
        return rivals.get(one).conflicts(rivals.get(other));
    }
}
