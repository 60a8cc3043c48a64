package org.evoloop.rehearsal;

import java.util.List;
import java.util.Set;
import org.evoloop.engine.Output;
import org.evoloop.evolution.BrokenPlan;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Step;
import org.jspecify.annotations.Nullable;

/**
 * How an event ended.
 *
 * <p>Threading: immutable.
 *
 * @param ended the core's output
 * @param verdict the same in words
 * @param took how many steps of its last plan had had their effect
 * @param guards the guards that held for the decision
 * @param broken the plans for it that had failed before its last one; null if there was only one
 * @param undecided whether it had its turn, but a component failed or dismissed it before the models decided
 * @since 0.1
 */
public record Ending(
        Output.Ended ended,
        Verdict verdict,
        int took,
        Set<String> guards,
        @Nullable BrokenPlan broken,
        boolean undecided) {
    public Ending {
        guards = Set.copyOf(guards);
    }

    /**
     * Why {@code step} of other models fails, since it failed here; empty if it succeeds.
     *
     * @param before how many steps have failed before it
     * @param taken how many steps of the plan have had their effect
     */
    String failure(Step step, int before, int taken) {
        List<Step> failed = broken == null ? List.of() : broken.failed();
        if (broken != null && before < failed.size()) {
            Step next = failed.get(before);
            boolean same = next.source().equals(step.source()) && next.trigger().equals(step.trigger());
            return same ? broken.reason() : "";
        }
        boolean isBroken = ended.outcome().isIncomplete() && ended.decision() == null;
        return isBroken && took <= taken ? verdict.why() : "";
    }

    /** The same as if the device had been found where it is now; null if it is where it was. */
    @Nullable
    Ending ifMoved() {
        boolean moved = !ended.before().original().equals(ended.after().original());
        return moved ? new Ending(Chronicle.asFound(ended), verdict, took, guards, broken, undecided) : null;
    }

    /** Why an effect of other models fails, since one failed here after the device had obeyed; empty if it succeeds. */
    String effectFailure() {
        boolean obeyed = ended.decision() != null && !(ended.decision() instanceof Decision.Impossible);
        return obeyed && ended.outcome().isIncomplete() ? ended.detail() : "";
    }
}
