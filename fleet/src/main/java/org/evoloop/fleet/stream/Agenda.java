package org.evoloop.fleet.stream;

import org.evoloop.fleet.wire.Wire;
import org.jspecify.annotations.Nullable;

/**
 * When devices are to be looked at because something is due there. By the wall clock, what devices have told before and
 * is still on its way comes first: as long as records are taken that have been lying there nobody is looked at, and
 * what is overdue when that is known waits a little.
 */
final class Agenda {
    private static final long CATCH_UP_MILLIS = 1_000;

    private final Schedule schedule = new Schedule();
    private final Clock clock;

    /** When the last record was written, and when it was taken. */
    private long writtenMillis;

    private long takenMillis;

    Agenda(Clock clock) {
        this.clock = clock;
        this.takenMillis = clock.nowMillis();
    }

    /** A record is taken that was written at {@code millis}. */
    void takes(long millis) {
        writtenMillis = millis;
        takenMillis = clock.nowMillis();
    }

    /** Something is due at the device then, and nothing before; {@link Schedule#set} has what stands for never. */
    void set(String id, long dueNanos) {
        long nowMillis = clock.nowMillis();
        boolean overdue = clock.isWall() && dueNanos < Wire.nanos(nowMillis);
        schedule.set(id, overdue ? Wire.nanos(nowMillis + CATCH_UP_MILLIS) : dueNanos);
    }

    /** The next device at which something is due; null if there is none, or records come first. */
    @Nullable
    String poll(long nowMillis) {
        return isBehind(nowMillis) ? null : schedule.poll(Wire.nanos(nowMillis));
    }

    /** Whether records are being taken that have been lying there. */
    boolean isBehind(long nowMillis) {
        return clock.isWall()
                && nowMillis - writtenMillis > CATCH_UP_MILLIS
                && nowMillis - takenMillis < CATCH_UP_MILLIS;
    }
}
