package org.evoloop.fleet.device;

import org.evoloop.statemachine.State;
import org.jspecify.annotations.Nullable;

/**
 * What has become of an {@link Order}.
 *
 * <p>Threading: immutable.
 *
 * @param sequence that of the order
 * @param reason why it was not done, for people
 * @param state where the device is, if it was asked and can tell
 * @param atNanos when, in nanoseconds since 1970
 * @since 0.1
 */
public record Answer(
        long sequence,
        Outcome outcome,
        String reason,
        @Nullable State state,
        long atNanos) {

    /** What can become of an order. */
    public enum Outcome {
        /** It was carried out. */
        SENT,
        /** It was not carried out, and will not be. */
        FAILED,
        /** Nobody knows whether it was. */
        IN_DOUBT
    }
}
