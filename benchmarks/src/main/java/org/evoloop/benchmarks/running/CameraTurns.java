package org.evoloop.benchmarks.running;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import org.HdrHistogram.Histogram;

/**
 * Measurements in pairs of turns, without and with a camera, and whether the two differ significantly.
 *
 * <p>Turns of one kind vary by themselves. Therefore the pairs are bootstrapped: as many pairs as there are, drawn at
 * random with replacement, and each time the difference between all events with and all events without a camera. 95 %
 * of these differences are in the interval. If it contains 0, no difference was measured.
 *
 * <p>Threading: for one thread.
 */
final class CameraTurns {
    private static final double[] PERCENTILES = {50, 90, 99, 99.9};
    private static final int DRAWS = 1_000;
    private static final double OUTSIDE = 0.025;
    private static final long SEED = 1;
    private static final double NANOS_PER_MICRO = 1e3;

    private final List<Histogram> without = new ArrayList<>();
    private final List<Histogram> with = new ArrayList<>();

    /** Adds the latencies of a pair of turns, in nanoseconds. */
    void add(Histogram nanosWithout, Histogram nanosWith) {
        without.add(nanosWithout);
        with.add(nanosWith);
    }

    int pairs() {
        return with.size();
    }

    /** A table, in microseconds. */
    String table() {
        String row = "%-6s %24s %24s %32s  %s%n";
        StringBuilder table = new StringBuilder(String.format(
                row, "us", "without (each turn's)", "with (each turn's)", "difference, 95 % interval", "cost"));
        double[][] drawn = drawnDifferences();
        double[] difference = differences(sum(without), sum(with));
        for (int index = 0; index < PERCENTILES.length; index++) {
            double low = drawn[index][(int) (OUTSIDE * DRAWS)];
            double high = drawn[index][(int) ((1 - OUTSIDE) * DRAWS) - 1];
            table.append(String.format(
                    row,
                    "p" + Double.toString(PERCENTILES[index]).replaceFirst("\\.0$", ""),
                    figures(without, PERCENTILES[index]),
                    figures(with, PERCENTILES[index]),
                    String.format(Locale.ROOT, "%+.1f, %+.1f to %+.1f", difference[index], low, high),
                    low > 0 ? "measured" : high < 0 ? "less than none" : "none that can be measured"));
        }
        return table.toString();
    }

    /** The percentile of all events, and in brackets the minimum and maximum over the turns. */
    private static String figures(List<Histogram> turns, double percentile) {
        double[] each = turns.stream()
                .mapToDouble(turn -> micros(turn, percentile))
                .sorted()
                .toArray();
        return String.format(
                Locale.ROOT, "%.1f (%.1f-%.1f)", micros(sum(turns), percentile), each[0], each[each.length - 1]);
    }

    /** For each percentile, in ascending order. */
    private double[][] drawnDifferences() {
        SplittableRandom random = new SplittableRandom(SEED);
        double[][] drawn = new double[PERCENTILES.length][DRAWS];
        for (int draw = 0; draw < DRAWS; draw++) {
            List<Histogram> drawnWithout = new ArrayList<>();
            List<Histogram> drawnWith = new ArrayList<>();
            for (int pair = 0; pair < without.size(); pair++) {
                int chosen = random.nextInt(without.size());
                drawnWithout.add(without.get(chosen));
                drawnWith.add(with.get(chosen));
            }
            double[] differences = differences(sum(drawnWithout), sum(drawnWith));
            for (int index = 0; index < PERCENTILES.length; index++) {
                drawn[index][draw] = differences[index];
            }
        }
        Arrays.stream(drawn).forEach(Arrays::sort);
        return drawn;
    }

    private static double[] differences(Histogram nanosWithout, Histogram nanosWith) {
        return Arrays.stream(PERCENTILES)
                .map(percentile -> micros(nanosWith, percentile) - micros(nanosWithout, percentile))
                .toArray();
    }

    private static Histogram sum(List<Histogram> turns) {
        Histogram sum = new Histogram(turns.get(0));
        turns.forEach(sum::add);
        return sum;
    }

    private static double micros(Histogram nanos, double percentile) {
        return nanos.getValueAtPercentile(percentile) / NANOS_PER_MICRO;
    }
}
