package org.evoloop.fleet.demo;

import java.util.Arrays;

/** How long something took, as often as it happened. */
public final class Latencies {
    private long[] millis = new long[1_024];
    private int size;

    /** One more. */
    public void add(long each) {
        if (size == millis.length) {
            millis = Arrays.copyOf(millis, 2 * size);
        }
        millis[size++] = each;
    }

    /** What {@code percent} of them did not exceed, in milliseconds; 0 if there are none. */
    public long percentile(double percent) {
        if (size == 0) {
            return 0;
        }
        long[] sorted = Arrays.copyOf(millis, size);
        Arrays.sort(sorted);
        return sorted[(int) Math.min(size - 1L, Math.round(Math.ceil(percent / 100 * size)) - 1)];
    }

    /** How many there are. */
    public int size() {
        return size;
    }

    /** Begins anew. */
    public void clear() {
        size = 0;
    }
}
