package org.evoloop.study;

import java.util.Arrays;

/**
 * When something happened each time, in nanoseconds of one clock.
 *
 * <p>Threading: for one thread at a time.
 */
final class TimeLog {
    private long[] nanos = new long[16];
    private int size;

    /** @param atNanos not before the last one */
    void add(long atNanos) {
        if (size == nanos.length) {
            nanos = Arrays.copyOf(nanos, 2 * size);
        }
        nanos[size++] = atNanos;
    }

    int size() {
        return size;
    }

    /** When it happened for the {@code number}th time, from 1 on. */
    long at(int number) {
        return nanos[number - 1];
    }

    /** How often it has happened until then, that moment included. */
    int until(long lastNanos) {
        int place = Arrays.binarySearch(nanos, 0, size, lastNanos);
        while (place >= 0 && place + 1 < size && nanos[place + 1] == lastNanos) {
            place++;
        }
        return place >= 0 ? place + 1 : -place - 1;
    }
}
