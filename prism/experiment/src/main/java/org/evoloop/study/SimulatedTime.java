package org.evoloop.study;

import java.time.Duration;
import org.evoloop.time.Clock;
import org.evoloop.time.ManualClock;

/**
 * The time of a {@link Bench}, which passes while somebody takes some of it.
 *
 * <p>Threading: thread-safe. What falls due while time passes may wake a thread that takes time itself; that one waits
 * until the first is done, so that the clock never goes back.
 */
final class SimulatedTime {
    private final ManualClock clock = new ManualClock();

    /** The clock that shows it. */
    Clock clock() {
        return clock;
    }

    long nanos() {
        return clock.nanoTime();
    }

    /** Lets time pass, and what falls due meanwhile happen. */
    synchronized void pass(Duration duration) {
        clock.advance(duration);
    }

    /** Lets time pass until then; none if it was before. */
    synchronized void passUntil(long untilNanos) {
        clock.advance(Duration.ofNanos(Math.max(0, untilNanos - clock.nanoTime())));
    }
}
