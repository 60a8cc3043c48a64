package org.evoloop.journal;

import java.time.Instant;
import java.util.concurrent.TimeUnit;

/** The time of day as one number. */
final class Times {
    private Times() {}

    /** Nanoseconds since 1970, good until 2262. */
    static long nanos(Instant time) {
        return TimeUnit.SECONDS.toNanos(time.getEpochSecond()) + time.getNano();
    }
}
