package org.evoloop.engine;

import org.evoloop.evolution.BrokenPlan;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Step;
import org.evoloop.statemachine.State;
import org.jspecify.annotations.Nullable;

/**
 * An occurrence that waits for its turn or is in progress.
 *
 * <p>Threading: immutable.
 *
 * @param number counts the occurrences of a converter, from 1
 * @param from the device's state before this fact, if the record has followed it; null if not, or if it is not a fact
 * @param own the step of its model that the device took; null if it took none
 * @param stepsBefore how many steps had been sent when it was observed
 * @param attempts how often its plan was overtaken
 * @param broken the failed plan for it; null if there is none, or nothing more is to be done about it
 * @since 0.1
 */
public record Pending(
        long number,
        Occurrence occurrence,
        @Nullable State from,
        @Nullable Step own,
        long stepsBefore,
        int attempts,
        @Nullable BrokenPlan broken) {

    /** An occurrence without a failed plan. */
    public Pending(
            long number,
            Occurrence occurrence,
            @Nullable State from,
            @Nullable Step own,
            long stepsBefore,
            int attempts) {
        this(number, occurrence, from, own, stepsBefore, attempts, null);
    }

    /** Whether it is a fact, or about one. */
    boolean hasHappened() {
        return from != null || occurrence.isFact();
    }

    /** Whether it has its turn before what is only asked for: a fact, or the recovery from a plan that has failed. */
    boolean goesFirst() {
        return hasHappened() || broken != null;
    }

    /** Whether it is lost when the queue is full: an event of a controller. */
    boolean mayBeLost() {
        return !hasHappened() && occurrence.source().isButton();
    }

    /** A copy for another attempt. */
    Pending again() {
        return new Pending(number, occurrence, from, own, stepsBefore, attempts + 1, broken);
    }

    /** A copy for another attempt, after a plan for it has failed. */
    Pending after(BrokenPlan plan) {
        return new Pending(number, occurrence, from, own, stepsBefore, attempts + 1, plan);
    }

    /** What failed before, if a plan for it did, and {@code reason}. */
    String afterBroken(String reason) {
        return broken == null ? reason : broken.reason() + "; then " + reason;
    }

    /** A copy in the visit {@code after}, if it belongs to the visit {@code before}. */
    Pending carriedOver(long before, long after) {
        boolean belongs = occurrence.visit() == before && before != Occurrence.ANY_VISIT;
        return belongs ? with(Reframed.inVisit(occurrence, after)) : this;
    }

    /** A copy with its times shifted. */
    Pending later(long nanos) {
        return with(Reframed.later(occurrence, nanos));
    }

    private Pending with(Occurrence another) {
        return new Pending(number, another, from, own, stepsBefore, attempts, broken);
    }
}
