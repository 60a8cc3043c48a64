package org.evoloop.statechart;

import java.util.List;
import java.util.Set;

/**
 * The result of one run-to-completion step.
 *
 * @param target the stable state reached
 * @param effects the behaviors that ran, in order
 * @param left the states that were left, even if they were entered again
 * @param entered the vertices that were entered, even if they were left again
 */
record StepResult(StableConfiguration target, List<String> effects, Set<Node> left, Set<Node> entered) {
    /** Whether the machine does the same, though by other transitions. */
    boolean isLike(StepResult other) {
        return target.equals(other.target)
                && effects.equals(other.effects)
                && left.equals(other.left)
                && still() == other.still();
    }

    /** Whether nothing was left or entered. */
    boolean still() {
        return left.isEmpty() && entered.isEmpty();
    }
}
