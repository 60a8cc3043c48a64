package org.evoloop.engine;

import java.util.List;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Step;
import org.jspecify.annotations.Nullable;

/**
 * Why the device's state is not certain.
 *
 * <p>Threading: immutable.
 *
 * @param why for people
 * @param number the occurrence in whose conversion it arose; {@value #NO_NUMBER} if it did not arise in one
 * @param step the step for which it is unknown whether or when it had its effect; null if it is about no step
 * @param stepsBefore how many steps had been sent before; {@value #UNSETTLED} if another step was in doubt then, so
 *     that knowing about this one is not enough
 * @param meanwhile what the device did by itself, or where it was found, since the step was about to be sent
 * @param settled whether the device has reported its state, so that the record is certain unless the step is reported
 *     to have had its effect after all
 * @param interrupted the decision in whose plan it arose, if that leads to a new state which needs the device somewhere:
 *     if the device is there, the transition is taken after all; null for any other, and once that is decided
 * @since 0.1
 */
public record Doubt(
        String why,
        long number,
        @Nullable Step step,
        long stepsBefore,
        List<Occurrence> meanwhile,
        boolean settled,
        @Nullable Decision interrupted) {
    static final long UNSETTLED = -1;

    /** No occurrence has this number. */
    static final long NO_NUMBER = 0;

    /** The doubt after a report that contradicts the record; {@code last} may still be settled by what it is about. */
    static Doubt contradicted(@Nullable Doubt last, String why) {
        return last == null
                ? new Doubt(why, NO_NUMBER, null, UNSETTLED, List.of(), false, null)
                : new Doubt(why, last.number, last.step, UNSETTLED, last.meanwhile, false, null);
    }

    Doubt acted(Occurrence fact) {
        return new Doubt(why, number, step, stepsBefore, Overlap.add(meanwhile, fact), settled, interrupted);
    }

    Doubt settled(boolean nowSettled) {
        return new Doubt(why, number, step, stepsBefore, meanwhile, nowSettled, null);
    }

    /** The device has reported its state without being asked, and what that means is not decided yet. */
    Doubt reported(@Nullable Decision undecided) {
        return new Doubt(why, number, step, stepsBefore, meanwhile, true, undecided);
    }

    /** Whether the device has reported its state, but what that means is not decided yet. */
    boolean isReported() {
        return settled && interrupted != null;
    }

    /** The same doubt in terms of other models. */
    Doubt of(@Nullable Step sameStep, List<Occurrence> sameMeanwhile) {
        return new Doubt(why, number, sameStep, stepsBefore, sameMeanwhile, settled, null);
    }

    Doubt later(long nanos) {
        return new Doubt(why, number, step, stepsBefore, Reframed.later(meanwhile, nanos), settled, interrupted);
    }
}
