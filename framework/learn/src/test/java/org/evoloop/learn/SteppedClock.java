package org.evoloop.learn;

import java.time.Duration;
import java.time.Instant;
import org.evoloop.time.Clock;
import org.evoloop.time.ManualClock;

/** A manual clock that a sleep advances, for one thread. */
final class SteppedClock implements Clock {
    private final ManualClock clock = new ManualClock();

    void advance(Duration duration) {
        clock.advance(duration);
    }

    @Override
    public long nanoTime() {
        return clock.nanoTime();
    }

    @Override
    public Instant wallTime() {
        return clock.wallTime();
    }

    @Override
    public Timer schedule(Duration delay, Runnable task) {
        return clock.schedule(delay, task);
    }

    @Override
    public void sleep(Duration duration) {
        clock.advance(duration);
    }

    @Override
    public boolean ownsCurrentThread() {
        return clock.ownsCurrentThread();
    }

    @Override
    public void close() {
        clock.close();
    }
}
