package org.evoloop.benchmarks.report;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;

/**
 * One line of the table: a figure of ours, what it is held against, and what shall be reached.
 *
 * <p>Threading: immutable.
 *
 * @param what was measured
 * @param ours in {@code unit}
 * @param goal what counts
 * @param peers others on the same thing, in {@code unit}, for comparison alone
 */
public record Row(String what, String unit, double ours, Goal goal, Map<String, Double> peers) {
    public Row {
        // Copied in order, which Map.copyOf would not keep.
        peers = Collections.unmodifiableMap(new LinkedHashMap<>(peers));
    }

    /** A row without peers. */
    public Row(String what, String unit, double ours, Goal goal) {
        this(what, unit, ours, goal, Map.of());
    }

    /** Whether the goal is reached. */
    public boolean reached() {
        double value = goal.ratio(ours);
        return goal.atLeast() ? value >= goal.bound() : value <= goal.bound();
    }

    /**
     * What shall be reached.
     *
     * @param against what the figure is divided by, as {@code name}; 1 and empty for a figure that stands by itself
     * @param bound of the ratio
     * @param atLeast whether the bound is the least rather than the most
     */
    public record Goal(String name, double against, double bound, boolean atLeast) {

        /** At most so much. */
        public static Goal atMost(double bound) {
            return new Goal("", 1, bound, false);
        }

        /** At least so much. */
        public static Goal least(double bound) {
            return new Goal("", 1, bound, true);
        }

        /** At most so many times what something else took in the same run. */
        public static Goal atMostTimes(double bound, String name, double against) {
            return new Goal(name, against, bound, false);
        }

        /** At least so many times what something else reached in the same run. */
        public static Goal atLeastTimes(double bound, String name, double against) {
            return new Goal(name, against, bound, true);
        }

        /** The figure that is held against the bound. */
        public double ratio(double ours) {
            return ours / against;
        }

        /** The goal in the unit of the figure itself. */
        public double limit() {
            return bound * against;
        }

        /** Whether it is a ratio to something else. */
        public boolean isRatio() {
            return !name.isEmpty();
        }
    }
}
