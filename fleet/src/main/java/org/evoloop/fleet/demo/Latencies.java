package org.evoloop.fleet.demo;

import java.util.Arrays;

/** A list of durations. */
public final class Latencies {
    private long[] millis = new long[1_024];
    private int size;

    /** Adds a duration. */
    public void add(long each) {
        if (size == millis.length) {
            millis = Arrays.copyOf(millis, 2 * size);
        }
        millis[size++] = each;
    }

    /** The percentile {@code percent}, in milliseconds; 0 if there are no durations. */
    public long percentile(double percent) {
        if (size == 0) {
            return 0;
        }
        long[] sorted = Arrays.copyOf(millis, size);
        Arrays.sort(sorted);
        return sorted[(int) Math.min(size - 1L, Math.round(Math.ceil(percent / 100 * size)) - 1)];
    }

    /** The number of durations. */
    public int size() {
        return size;
    }

    /** Removes all durations. */
    public void clear() {
        size = 0;
    }
}
