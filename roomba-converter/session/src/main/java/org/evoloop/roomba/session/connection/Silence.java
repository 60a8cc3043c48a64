package org.evoloop.roomba.session.connection;

import java.time.Duration;
import java.time.Instant;
import org.evoloop.time.Clock;

/**
 * How long the robot has been silent, as far as this program could hear it. A check that comes late shows that the
 * program was held up, for example by a busy computer. The robot's frames may then still wait in the driver, so that
 * time does not count.
 *
 * <p>Threading: thread-safe.
 */
final class Silence {
    private final Clock clock;
    private long heardNanos;
    private long heldUpNanos;
    private long dueNanos;

    Silence(Clock clock) {
        this.clock = clock;
    }

    /** The robot has sent a frame, or it is listened to from now on. */
    synchronized void broken() {
        heardNanos = clock.nanoTime();
        heldUpNanos = 0;
    }

    /** The next check is due after this delay. */
    synchronized void expectCheck(Duration delay) {
        dueNanos = clock.nanoTime() + delay.toNanos();
    }

    /** The check that was due has begun. */
    synchronized void checked() {
        heldUpNanos += Math.max(0, clock.nanoTime() - Math.max(dueNanos, heardNanos));
    }

    /** Whether there was no frame for at least {@code limit} of the time that counts. */
    synchronized boolean hasLasted(Duration limit) {
        return clock.nanoTime() - heardNanos - heldUpNanos >= limit.toNanos();
    }

    /** The time of day of the last frame. */
    synchronized Instant since() {
        return clock.wallTime().minusNanos(clock.nanoTime() - heardNanos);
    }
}
