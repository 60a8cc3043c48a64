package org.evoloop.loop;

import java.util.ArrayDeque;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import org.jspecify.annotations.Nullable;

/**
 * A queue of a fixed capacity, first come first served; an occurrence that finds it full is lost.
 *
 * <p>Threading: as {@link Intake}; monitors that report more than there is room for must not hold up the threads that
 * make room, so {@link #atOnce} takes no lock.
 */
final class PlainQueue<O> implements Intake<O> {
    private final int capacity;
    private final ArrayDeque<O> waiting = new ArrayDeque<>();
    // The length of the queue for those who hold no lock. It may be out of date by one: an occurrence that is dropped
    // here could just as well have come a moment earlier.
    private final AtomicInteger size = new AtomicInteger();
    private final AtomicLong dropped = new AtomicLong();
    private final AtomicBoolean dropping = new AtomicBoolean();
    private volatile boolean open;
    private boolean busy;
    private int highest;
    private long taken;
    private long refused;

    PlainQueue(int capacity) {
        this.capacity = capacity;
    }

    @Override
    public @Nullable Admission atOnce(O occurrence) {
        return open && size.get() >= Math.max(capacity, 1) ? drop() : null;
    }

    @Override
    public Admission offer(O occurrence) {
        if (!open) {
            refused++;
            return Admission.REFUSED;
        }
        if (!hasRoom(occurrence)) {
            return drop();
        }
        if (dropping.get()) {
            dropping.set(false);
        }
        waiting.add(occurrence);
        size.setRelease(waiting.size());
        taken++;
        highest = Math.max(highest, waiting.size());
        return Admission.TAKEN;
    }

    private Admission drop() {
        dropped.incrementAndGet();
        // Read before it is written: all monitors come here while the queue is full, and a write by each would slow
        // them down.
        boolean first = !dropping.get() && dropping.compareAndSet(false, true);
        return first ? Admission.FIRST_DROPPED : Admission.DROPPED;
    }

    /** An idle loop has room for the occurrence that it takes at once, even with capacity 0. */
    @Override
    public boolean hasRoom(O occurrence) {
        return waiting.size() < Math.max(capacity, busy ? 0 : 1);
    }

    @Override
    public @Nullable O next() {
        O next = open ? waiting.poll() : null;
        size.setRelease(waiting.size());
        busy = next != null;
        return next;
    }

    @Override
    public void ended() {
        busy = false;
    }

    @Override
    public void opened() {
        open = true;
    }

    @Override
    public void closed() {
        open = false;
        refused += waiting.size();
        waiting.clear();
        size.setRelease(0);
    }

    @Override
    public QueueStatus status() {
        return new QueueStatus(waiting.size(), capacity, highest, taken, dropped.get(), refused);
    }
}
