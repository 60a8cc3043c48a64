package org.evoloop.evolution;

/**
 * The outcome of an occurrence.
 *
 * @since 0.1
 */
public enum Outcome {
    /** It had its effect. */
    HANDLED,
    /** The new model has no transition for it, or a component dismissed it. */
    IGNORED,
    /**
     * It came too late: it was raised in an earlier visit of a state, overtaken by a step sent since, or pressed too long
     * before its turn.
     */
    STALE,
    /** It could not be carried out, or not completely. */
    FAILED,
    /** The queue was full. */
    DROPPED,
    /** An urgent event ended its plan. It counts among those that failed. */
    OVERTAKEN;

    /** Whether it had its turn, but not its whole effect. */
    public boolean isIncomplete() {
        return this == FAILED || this == OVERTAKEN;
    }
}
