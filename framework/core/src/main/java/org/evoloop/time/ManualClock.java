package org.evoloop.time;

import java.time.Duration;
import java.time.Instant;
import java.util.Comparator;
import java.util.Optional;
import java.util.PriorityQueue;
import org.jspecify.annotations.Nullable;

/**
 * A clock that advances only when {@link #advance} is called. It returns after all work that became due has
 * run, in the order of its times, on the caller's thread.
 *
 * <p>Threading: thread-safe; one thread at a time should advance it.
 *
 * @since 0.1
 */
public final class ManualClock implements Clock {
    private final PriorityQueue<Task> tasks =
            new PriorityQueue<>(Comparator.comparingLong(Task::dueNanos).thenComparingLong(Task::order));
    private long nowNanos;
    private long scheduled;

    /** The thread on which a task runs. */
    private volatile @Nullable Thread working;

    /** @param order the order of scheduling, in which tasks due at the same time run */
    private record Task(long dueNanos, long order, Runnable action) {}

    /** A clock that begins at zero. */
    public ManualClock() {}

    @Override
    public synchronized long nanoTime() {
        return nowNanos;
    }

    @Override
    public Instant wallTime() {
        return Instant.EPOCH.plusNanos(nanoTime());
    }

    @Override
    public synchronized Timer schedule(Duration delay, Runnable action) {
        Task task = new Task(nowNanos + Clock.requireDelay(delay).toNanos(), scheduled++, action);
        tasks.add(task);
        return () -> cancel(task);
    }

    private synchronized void cancel(Task task) {
        tasks.remove(task);
    }

    /**
     * Lets {@code duration} pass and runs the tasks that become due meanwhile, including those that these tasks
     * schedule.
     */
    public void advance(Duration duration) {
        long until = nanoTime() + duration.toNanos();
        for (Task due = pollDue(until); due != null; due = pollDue(until)) {
            Thread before = working;
            working = Thread.currentThread();
            try {
                due.action().run();
            } finally {
                working = before;
            }
        }
        synchronized (this) {
            nowNanos = until;
        }
    }

    private synchronized @Nullable Task pollDue(long until) {
        Task next = tasks.peek();
        if (next == null || next.dueNanos() > until) {
            return null;
        }
        nowNanos = Math.max(nowNanos, next.dueNanos());
        return tasks.poll();
    }

    /** The time until the next task is due; empty if none waits. */
    public synchronized Optional<Duration> untilNext() {
        Task next = tasks.peek();
        return next == null ? Optional.empty() : Optional.of(Duration.ofNanos(Math.max(0, next.dueNanos() - nowNanos)));
    }

    /** How many tasks wait for their time; for tests that look for timers left behind. */
    public synchronized int pendingTasks() {
        return tasks.size();
    }

    @Override
    public boolean ownsCurrentThread() {
        return working == Thread.currentThread();
    }

    /** Forgets all tasks. */
    @Override
    public synchronized void close() {
        tasks.clear();
    }
}
