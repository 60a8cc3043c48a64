package org.evoloop.benchmarks.report;

import org.HdrHistogram.Histogram;

/** Latencies of many events, in nanoseconds, and their percentiles. */
public final class Latencies {
    private static final long LONGEST_NANOS = 10_000_000_000L;

    private Latencies() {}

    /** An empty histogram of nanoseconds; recording into it allocates nothing. */
    public static Histogram histogram() {
        return new Histogram(LONGEST_NANOS, 3);
    }

    /** Prints the median and the 99th percentile in microseconds, as {@code NAME p50} and {@code NAME p99}. */
    public static void print(String name, Histogram nanos) {
        System.out.println(name + " p50 " + nanos.getValueAtPercentile(50) / 1e3);
        System.out.println(name + " p99 " + nanos.getValueAtPercentile(99) / 1e3);
    }
}
