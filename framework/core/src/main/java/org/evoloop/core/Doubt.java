package org.evoloop.core;

import java.util.List;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Step;

/**
 * Why the device's state is not certain.
 *
 * <p>Threading: immutable.
 *
 * @param why for people
 * @param number the occurrence in whose conversion it arose
 * @param step the step for which it is unknown whether or when it had its effect
 * @param stepsBefore how many steps had been sent before; {@value #UNSETTLED} if another step was in doubt then, so
 *     that knowing about this one is not enough
 * @param meanwhile what the device did by itself, or where it was found, since the step was about to be sent
 * @param settled whether the device has reported its state, so that the record is certain unless the step is reported
 *     to have had its effect after all
 * @since 0.1
 */
public record Doubt(String why, long number, Step step, long stepsBefore, List<Occurrence> meanwhile, boolean settled) {
    static final long UNSETTLED = -1;

    Doubt acted(Occurrence fact) {
        return new Doubt(why, number, step, stepsBefore, Overlap.add(meanwhile, fact), settled);
    }

    Doubt settled(boolean nowSettled) {
        return new Doubt(why, number, step, stepsBefore, meanwhile, nowSettled);
    }

    /** The same doubt in terms of other models. */
    Doubt of(Step sameStep, List<Occurrence> sameMeanwhile) {
        return new Doubt(why, number, sameStep, stepsBefore, sameMeanwhile, settled);
    }

    Doubt later(long nanos) {
        return new Doubt(why, number, step, stepsBefore, Reframed.later(meanwhile, nanos), settled);
    }
}
