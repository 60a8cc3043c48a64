package org.evoloop.core;

import java.util.ArrayList;
import java.util.List;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Step;

/**
 * That nobody knows for sure where the device is.
 *
 * <p>Threading: immutable.
 *
 * @param why for people
 * @param number the occurrence in whose conversion it arose
 * @param step the step of which nobody knows whether or when it had its effect
 * @param stepsBefore how many steps had been sent before; {@value #UNSETTLED} if there was another doubt then, so that
 *     knowing of this step is not enough
 * @param meanwhile what the device did by itself since the step was about to be sent
 */
public record Doubt(String why, long number, Step step, long stepsBefore, List<Occurrence> meanwhile) {
    static final long UNSETTLED = -1;

    Doubt acted(Occurrence fact) {
        List<Occurrence> more = new ArrayList<>(meanwhile);
        more.add(fact);
        return new Doubt(why, number, step, stepsBefore, List.copyOf(more));
    }
}
