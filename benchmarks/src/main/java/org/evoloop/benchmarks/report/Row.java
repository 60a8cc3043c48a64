package org.evoloop.benchmarks.report;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;

/**
 * One line of the table: our figure, what it is compared with, and the goal.
 *
 * <p>Threading: immutable.
 *
 * @param what was measured
 * @param ours our figure in {@code unit}
 * @param goal decides whether the row passes
 * @param peers the same measurement of others, in {@code unit}, only for comparison
 */
public record Row(String what, String unit, double ours, Goal goal, Map<String, Double> peers) {
    public Row {
        // Copied in order, which Map.copyOf would not preserve.
        peers = Collections.unmodifiableMap(new LinkedHashMap<>(peers));
    }

    /** A row without peers. */
    public Row(String what, String unit, double ours, Goal goal) {
        this(what, unit, ours, goal, Map.of());
    }

    /** Whether the goal is met. */
    public boolean reached() {
        double value = goal.ratio(ours);
        return goal.atLeast() ? value >= goal.bound() : value <= goal.bound();
    }

    /**
     * A goal.
     *
     * @param name of what the figure is compared with; empty for none
     * @param against the divisor of the figure; 1 for none
     * @param bound of the ratio
     * @param atLeast whether the bound is a minimum instead of a maximum
     */
    public record Goal(String name, double against, double bound, boolean atLeast) {

        /** At most this figure. */
        public static Goal atMost(double bound) {
            return new Goal("", 1, bound, false);
        }

        /** At least this figure. */
        public static Goal least(double bound) {
            return new Goal("", 1, bound, true);
        }

        /** At most this multiple of another figure in the same run. */
        public static Goal atMostTimes(double bound, String name, double against) {
            return new Goal(name, against, bound, false);
        }

        /** At least this multiple of another figure in the same run. */
        public static Goal atLeastTimes(double bound, String name, double against) {
            return new Goal(name, against, bound, true);
        }

        /** The figure that is compared with the bound. */
        public double ratio(double ours) {
            return ours / against;
        }

        /** The goal in the unit of the figure. */
        public double limit() {
            return bound * against;
        }

        /** Whether it is a ratio to another figure. */
        public boolean isRatio() {
            return !name.isEmpty();
        }
    }
}
