package org.evoloop.benchmarks.report;

import java.util.Locale;

/**
 * A converter's resource usage after a number of events.
 *
 * <p>Threading: immutable.
 *
 * @param seconds since the first event
 * @param heapMegabytes the heap in use after a collection
 * @param files open file descriptors
 * @param diskMegabytes the size of the journal
 * @param medianMicros from a monitor having an event to the call of the execute component, for the events since the
 *     previous sample
 */
public record SoakSample(
        long events,
        double seconds,
        double heapMegabytes,
        int threads,
        int files,
        double diskMegabytes,
        double medianMicros,
        double percentile99Micros,
        double percentile999Micros) {

    @Override
    public String toString() {
        return String.format(
                Locale.ROOT,
                "%,d events in %.0f s: heap %.1f MB, %d threads, %d files, journal %.1f MB, %.1f us median, %.1f us p99,"
                        + " %.1f us p99.9",
                events,
                seconds,
                heapMegabytes,
                threads,
                files,
                diskMegabytes,
                medianMicros,
                percentile99Micros,
                percentile999Micros);
    }
}
