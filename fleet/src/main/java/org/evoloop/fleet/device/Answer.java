package org.evoloop.fleet.device;

import org.evoloop.statemachine.State;
import org.jspecify.annotations.Nullable;

/**
 * The outcome of an {@link Order}.
 *
 * <p>Threading: immutable.
 *
 * @param sequence the order's sequence number
 * @param reason why it was not done, for people
 * @param state the device's state, if it was asked and is known
 * @param atNanos the time, in nanoseconds since 1970
 * @since 0.1
 */
public record Answer(
        long sequence,
        Outcome outcome,
        String reason,
        @Nullable State state,
        long atNanos) {

    /** The possible outcomes of an order. */
    public enum Outcome {
        /** It was carried out. */
        SENT,
        /** It was not carried out, and will not be. */
        FAILED,
        /** It is not known whether it was carried out. */
        IN_DOUBT
    }
}
