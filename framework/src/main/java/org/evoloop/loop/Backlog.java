package org.evoloop.loop;

import java.util.ArrayDeque;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import org.jspecify.annotations.Nullable;

/**
 * The occurrences that wait before the loop, and how many came, waited, were lost and refused.
 *
 * <p>Threading: guarded by its {@link Sequencer}, but for {@link #isFull} and {@link #drop}: monitors that tell more than
 * there is room for must not hold up the threads that make room.
 */
final class Backlog<O> {
    private final int capacity;
    private final ArrayDeque<O> waiting = new ArrayDeque<>();
    private final AtomicInteger size = new AtomicInteger();
    private final AtomicLong dropped = new AtomicLong();
    private final AtomicBoolean dropping = new AtomicBoolean();
    private int highest;
    private long taken;
    private long refused;

    Backlog(int capacity) {
        this.capacity = capacity;
    }

    /** Whether one more may come; an idle loop has room for the one that it takes at once, even without any queue. */
    boolean hasRoom(boolean idle) {
        return waiting.size() < Math.max(capacity, idle ? 1 : 0);
    }

    /** Whether there was no room a moment ago, whatever the loop is doing. */
    boolean isFull() {
        return size.get() >= Math.max(capacity, 1);
    }

    void add(O occurrence) {
        if (dropping.get()) {
            dropping.set(false);
        }
        waiting.add(occurrence);
        size.setRelease(waiting.size());
        taken++;
        highest = Math.max(highest, waiting.size());
    }

    @Nullable
    O poll() {
        O next = waiting.poll();
        size.setRelease(waiting.size());
        return next;
    }

    void refuse() {
        refused++;
    }

    void refuseAll() {
        refused += waiting.size();
        waiting.clear();
        size.setRelease(0);
    }

    /** Counts one that is lost; true if it is the first since there was room. */
    boolean drop() {
        dropped.incrementAndGet();
        return !dropping.get() && dropping.compareAndSet(false, true);
    }

    QueueStatus status() {
        return new QueueStatus(waiting.size(), capacity, highest, taken, dropped.get(), refused);
    }
}
