package org.evoloop.loop;

import java.util.ArrayDeque;
import org.jspecify.annotations.Nullable;

/**
 * The occurrences that wait before the loop, and how many came, waited, were lost and refused.
 *
 * <p>Threading: guarded by its {@link Sequencer}.
 */
final class Backlog<O> {
    private final int capacity;
    private final ArrayDeque<O> waiting = new ArrayDeque<>();
    private int highest;
    private long taken;
    private long dropped;
    private long refused;
    private boolean dropping;

    Backlog(int capacity) {
        this.capacity = capacity;
    }

    /** Whether one more may come; an idle loop has room for the one that it takes at once, even without any queue. */
    boolean hasRoom(boolean idle) {
        return waiting.size() < Math.max(capacity, idle ? 1 : 0);
    }

    void add(O occurrence) {
        dropping = false;
        waiting.add(occurrence);
        taken++;
        highest = Math.max(highest, waiting.size());
    }

    @Nullable
    O poll() {
        return waiting.poll();
    }

    void refuse() {
        refused++;
    }

    void refuseAll() {
        refused += waiting.size();
        waiting.clear();
    }

    /** Counts one that is lost; true if it is the first since there was room. */
    boolean drop() {
        boolean first = !dropping;
        dropping = true;
        dropped++;
        return first;
    }

    QueueStatus status() {
        return new QueueStatus(waiting.size(), capacity, highest, taken, dropped, refused);
    }
}
