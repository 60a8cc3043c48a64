package org.evoloop.study;

import java.time.Duration;
import java.util.SplittableRandom;

/**
 * Random durations, one independent stream for each purpose, so that two mechanisms with the same seed see the same
 * arrivals.
 *
 * <p>Threading: for one thread at a time.
 */
final class RandomTimes {
    private static final double NANOS = 1e9;

    private final SplittableRandom arrivals;
    private final SplittableRandom conversions;
    private final SplittableRandom actions;
    private final SplittableRandom holdOffs;
    private final SplittableRandom disturbances;

    RandomTimes(long seed) {
        SplittableRandom root = new SplittableRandom(seed);
        arrivals = root.split();
        conversions = root.split();
        actions = root.split();
        holdOffs = root.split();
        disturbances = root.split();
    }

    Duration untilArrival(double perSecond) {
        return exponential(arrivals, 1 / perSecond);
    }

    Duration conversion(ConversionTime time) {
        Duration sum = Duration.ZERO;
        for (int phase = 0; phase < time.phases(); phase++) {
            sum = sum.plus(exponential(conversions, time.first()));
        }
        return time.more() > 0 && conversions.nextDouble() < time.more()
                ? sum.plus(exponential(conversions, time.last()))
                : sum;
    }

    Duration action(double meanSeconds) {
        return exponential(actions, meanSeconds);
    }

    /** The sum of {@code phases} exponential times: the more of them, the closer to constant. */
    Duration holdOff(double meanSeconds, int phases) {
        Duration sum = Duration.ZERO;
        for (int phase = 0; phase < phases; phase++) {
            sum = sum.plus(exponential(holdOffs, meanSeconds / phases));
        }
        return sum;
    }

    Duration untilDisturbance(double meanSeconds) {
        return exponential(disturbances, meanSeconds);
    }

    private static Duration exponential(SplittableRandom random, double meanSeconds) {
        return Duration.ofNanos(Math.round(-Math.log1p(-random.nextDouble()) * meanSeconds * NANOS));
    }
}
