package org.evoloop.benchmarks.report;

import java.util.Locale;

/**
 * What a converter holds after so many events.
 *
 * <p>Threading: immutable.
 *
 * @param seconds since the first event
 * @param heapMegabytes what is left of the heap after a collection
 * @param files open file descriptors
 * @param diskMegabytes what the journal takes
 * @param medianMicros from where a monitor has an event to where the execute component is called, of the events since
 *     the sample before
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
