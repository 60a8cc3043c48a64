package org.evoloop.roomba.simulator.webcam;

import org.jspecify.annotations.Nullable;

/**
 * Passes the newest of many things to each thread that is ready for one; older things are dropped.
 *
 * <p>Threading: thread-safe.
 */
final class Newest<T> {
    /** The things that are handed on, counted from 1. */
    record Numbered<T>(long number, T thing) {}

    private @Nullable T thing;
    private long number;
    private boolean closed;

    /** Never waits. */
    synchronized void put(T newer) {
        thing = newer;
        number++;
        notifyAll();
    }

    /** The number of the newest thing; 0 before the first. */
    synchronized long number() {
        return number;
    }

    /** Waits for a thing that is newer than the one of a number; null if there will be none. */
    synchronized @Nullable Numbered<T> after(long known) throws InterruptedException {
        while (number <= known && !closed) {
            wait();
        }
        T newest = thing;
        return closed || newest == null ? null : new Numbered<>(number, newest);
    }

    /** There will be no more. */
    synchronized void close() {
        closed = true;
        notifyAll();
    }
}
