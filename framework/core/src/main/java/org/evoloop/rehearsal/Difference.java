package org.evoloop.rehearsal;

import java.time.Instant;
import org.evoloop.evolution.Occurrence;
import org.jspecify.annotations.Nullable;

/**
 * An event that the other models decide differently.
 *
 * <p>Threading: immutable.
 *
 * @param at when it occurred
 * @param recorded the verdict in the recording; null for a timer that only the other models have
 * @param other the other models' verdict; null if the event would not have happened
 * @since 0.1
 */
public record Difference(
        Instant at,
        Occurrence occurrence,
        @Nullable Verdict recorded,
        @Nullable Verdict other) {

    /** The recorded verdict, for messages. */
    public String then() {
        return recorded == null ? "had no such timer" : recorded.toString();
    }

    /** The other models' verdict, for messages. */
    public String now() {
        return other == null ? "would not have happened" : other.toString();
    }

    @Override
    public String toString() {
        return at + "  " + occurrence + "\n    then  " + then() + "\n    now   " + now();
    }
}
