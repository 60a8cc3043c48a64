package org.evoloop.time;

import java.time.Duration;
import java.time.Instant;

/** A clock that stands still; its time of day can be set, as by a person or over the network. */
public final class SetClock implements Clock {
    private final ManualClock time = new ManualClock();
    private Duration offset = Duration.ZERO;

    /** Sets the time of day, such as {@code 2026-11-23T06:00:00Z}. */
    public void set(String wall) {
        offset = Duration.between(time.wallTime(), Instant.parse(wall));
    }

    public void advance(Duration duration) {
        time.advance(duration);
    }

    public int pendingTasks() {
        return time.pendingTasks();
    }

    @Override
    public long nanoTime() {
        return time.nanoTime();
    }

    @Override
    public Instant wallTime() {
        return time.wallTime().plus(offset);
    }

    @Override
    public Timer schedule(Duration delay, Runnable task) {
        return time.schedule(delay, task);
    }

    @Override
    public boolean ownsCurrentThread() {
        return time.ownsCurrentThread();
    }

    @Override
    public void close() {
        time.close();
    }
}
