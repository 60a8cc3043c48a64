package org.evoloop.payload;

import java.time.Duration;
import org.evoloop.time.Clock;

/**
 * The time that a device needs after a command, before it takes the next one.
 *
 * <p>Threading: thread-safe.
 *
 * @since 0.1
 */
public final class Rest {
    private final Clock clock;
    private final Duration needed;
    private long readyNanos;
    private boolean used;

    /** @throws IllegalArgumentException if the duration is negative, or longer than a clock takes */
    public Rest(Clock clock, Duration needed) {
        this.clock = clock;
        this.needed = Clock.requireDelay(needed);
    }

    /** A command has ended; the device rests from now on. */
    public synchronized void begin() {
        used = true;
        readyNanos = clock.nanoTime() + needed.toNanos();
    }

    /** Waits until the device has rested. */
    public void await() throws InterruptedException {
        long left = leftNanos();
        if (left > 0) {
            clock.sleep(Duration.ofNanos(left));
        }
    }

    /** Whether it has rested. */
    public boolean isOver() {
        return leftNanos() <= 0;
    }

    private synchronized long leftNanos() {
        return used ? readyNanos - clock.nanoTime() : 0;
    }
}
