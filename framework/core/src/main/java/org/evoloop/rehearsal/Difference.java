package org.evoloop.rehearsal;

import java.time.Instant;
import org.evoloop.evolution.Occurrence;
import org.jspecify.annotations.Nullable;

/**
 * An event of which the other models make something else.
 *
 * <p>Threading: immutable.
 *
 * @param at when it occurred
 * @param recorded what became of it; null for a timer that only the other models have
 * @param other what would have; null if the event would not have happened
 * @since 0.1
 */
public record Difference(
        Instant at,
        Occurrence occurrence,
        @Nullable Verdict recorded,
        @Nullable Verdict other) {

    /** For messages: what became of it. */
    public String then() {
        return recorded == null ? "had no such timer" : recorded.toString();
    }

    /** For messages: what the other models make of it. */
    public String now() {
        return other == null ? "would not have happened" : other.toString();
    }

    @Override
    public String toString() {
        return at + "  " + occurrence + "\n    then  " + then() + "\n    now   " + now();
    }
}
