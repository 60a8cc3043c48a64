package org.evoloop.loop;

/**
 * How the queue before the loop fares.
 *
 * <p>Threading: immutable; a picture of one moment.
 *
 * @param depth how many occurrences wait
 * @param capacity how many may wait
 * @param highest how many have ever waited at once
 * @param taken how many have been queued
 * @param dropped how many were lost because the queue was full
 * @param refused how many came while the loop was closed, or still waited when it closed
 */
public record QueueStatus(int depth, int capacity, int highest, long taken, long dropped, long refused) {
    static final QueueStatus EMPTY = new QueueStatus(0, 0, 0, 0, 0, 0);

    QueueStatus plusTaken(int nowWaiting) {
        return new QueueStatus(depth, capacity, Math.max(highest, nowWaiting), taken + 1, dropped, refused);
    }

    QueueStatus plusDropped() {
        return new QueueStatus(depth, capacity, highest, taken, dropped + 1, refused);
    }

    QueueStatus plusRefused(int more) {
        return new QueueStatus(depth, capacity, highest, taken, dropped, refused + more);
    }

    QueueStatus withDepth(int nowWaiting, int ofCapacity) {
        return new QueueStatus(nowWaiting, ofCapacity, highest, taken, dropped, refused);
    }
}
