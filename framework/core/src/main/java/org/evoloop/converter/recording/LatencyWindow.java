package org.evoloop.converter.recording;

import java.util.Arrays;
import org.evoloop.converter.ConverterStatus;
import org.evoloop.converter.running.CoreDriver;

/**
 * The conversion times of the last {@value #SIZE} events.
 *
 * <p>Threading: guarded by the lock of the {@link CoreDriver}.
 */
public final class LatencyWindow {
    private static final int SIZE = 1024;

    private final long[] nanos = new long[SIZE];
    private int recorded;
    private int next;

    public void record(long conversionNanos) {
        nanos[next] = conversionNanos;
        next = (next + 1) % SIZE;
        recorded = Math.min(recorded + 1, SIZE);
    }

    public ConverterStatus.ConversionTime summary() {
        if (recorded == 0) {
            return new ConverterStatus.ConversionTime(0, 0, 0, 0);
        }
        long[] sorted = Arrays.copyOf(nanos, recorded);
        Arrays.sort(sorted);
        long last = nanos[(next + SIZE - 1) % SIZE];
        return new ConverterStatus.ConversionTime(
                recorded, last, sorted[(recorded - 1) / 2], sorted[(int) Math.ceil(recorded * 0.99) - 1]);
    }
}
