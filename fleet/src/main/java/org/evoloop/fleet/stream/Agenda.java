package org.evoloop.fleet.stream;

import org.evoloop.fleet.wire.Wire;
import org.jspecify.annotations.Nullable;

/**
 * The devices at which something is due, and when. With the wall clock, a backlog of records comes first: while old
 * records are still being processed, no device is polled, and something that is already overdue when it is set waits a
 * little.
 */
final class Agenda {
    private static final long CATCH_UP_MILLIS = 1_000;

    private final Schedule schedule = new Schedule();
    private final Clock clock;

    /** When the last record was written, and when it was processed. */
    private long writtenMillis;

    private long takenMillis;

    Agenda(Clock clock) {
        this.clock = clock;
        this.takenMillis = clock.nowMillis();
    }

    /** A record written at {@code millis} is being processed. */
    void takes(long millis) {
        writtenMillis = millis;
        takenMillis = clock.nowMillis();
    }

    /** Sets when something is next due at the device, as {@link Schedule#set} does. */
    void set(String id, long dueNanos) {
        long nowMillis = clock.nowMillis();
        boolean overdue = clock.isWall() && dueNanos < Wire.nanos(nowMillis);
        schedule.set(id, overdue ? Wire.nanos(nowMillis + CATCH_UP_MILLIS) : dueNanos);
    }

    /** The next device at which something is due; null if there is none, or there is a backlog of records. */
    @Nullable
    String poll(long nowMillis) {
        return isBehind(nowMillis) ? null : schedule.poll(Wire.nanos(nowMillis));
    }

    /** Whether a backlog of records is being processed. */
    boolean isBehind(long nowMillis) {
        return clock.isWall()
                && nowMillis - writtenMillis > CATCH_UP_MILLIS
                && nowMillis - takenMillis < CATCH_UP_MILLIS;
    }
}
