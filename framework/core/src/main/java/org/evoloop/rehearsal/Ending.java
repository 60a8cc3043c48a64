package org.evoloop.rehearsal;

import java.util.Set;
import org.evoloop.core.Outcome;
import org.evoloop.core.Output;

/**
 * How an event ended.
 *
 * <p>Threading: immutable.
 *
 * @param ended the core's output
 * @param verdict the same in words
 * @param took how many steps had had their effect
 * @param guards the guards that held for the decision
 * @since 0.1
 */
public record Ending(Output.Ended ended, Verdict verdict, int took, Set<String> guards) {
    public Ending {
        guards = Set.copyOf(guards);
    }

    /** Whether a step failed. */
    boolean isBroken() {
        return ended.outcome() == Outcome.FAILED && ended.decision() == null;
    }
}
