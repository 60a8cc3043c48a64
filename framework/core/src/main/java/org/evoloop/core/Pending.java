package org.evoloop.core;

import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Step;
import org.evoloop.statemachine.State;
import org.jspecify.annotations.Nullable;

/**
 * An occurrence that waits for its turn or has it.
 *
 * <p>Threading: immutable.
 *
 * @param number counts the occurrences of a converter, from 1
 * @param from where the device was before this fact, which the record has followed; null if it has not, or is no fact
 * @param own the step of its model that the device took; null if it took none
 * @param stepsBefore how many steps had been sent when it was observed
 * @param attempts how often its plan was overtaken
 * @since 0.1
 */
public record Pending(
        long number,
        Occurrence occurrence,
        @Nullable State from,
        @Nullable Step own,
        long stepsBefore,
        int attempts) {

    /** Whether it has happened at the device, or is about what has. */
    boolean hasHappened() {
        return from != null || occurrence.isFact();
    }

    /** The same for another attempt. */
    Pending again() {
        return new Pending(number, occurrence, from, own, stepsBefore, attempts + 1);
    }

    /** The same in the visit {@code after}, if it belongs to the visit {@code before}. */
    Pending carriedOver(long before, long after) {
        boolean belongs = occurrence.visit() == before && before != Occurrence.ANY_VISIT;
        return belongs ? with(Reframed.inVisit(occurrence, after)) : this;
    }

    /** The same so much later. */
    Pending later(long nanos) {
        return with(Reframed.later(occurrence, nanos));
    }

    private Pending with(Occurrence another) {
        return new Pending(number, another, from, own, stepsBefore, attempts);
    }
}
