package org.evoloop.study;

import java.time.Duration;

/**
 * The waiting times of one batch of events.
 *
 * <p>Threading: for one thread.
 */
final class WaitBatch {
    private static final double NANOS = 1e9;

    private final long[] longerThan;
    private long number;
    private long sumNanos;

    /** @param longestSeconds up to which waiting times are distinguished */
    WaitBatch(int longestSeconds) {
        longerThan = new long[longestSeconds + 1];
    }

    void add(Duration wait) {
        number++;
        sumNanos += wait.toNanos();
        for (int second = 0; second < longerThan.length && wait.toNanos() > second * NANOS; second++) {
            longerThan[second]++;
        }
    }

    double meanSeconds() {
        return sumNanos / NANOS / number;
    }

    double shareLongerThan(int second) {
        return longerThan[second] / (double) number;
    }
}
