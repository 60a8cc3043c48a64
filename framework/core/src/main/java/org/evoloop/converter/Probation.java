package org.evoloop.converter;

import static java.util.Objects.requireNonNull;

import java.time.Duration;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.DecisionTable;

/**
 * How long other models are on trial after they have taken over. The previous models come back if meanwhile an event
 * fails, the record of the device is in doubt, the device is found in another state than the record says, or a watch
 * reports a violation.
 *
 * <p>Threading: immutable.
 *
 * @param time how long the trial lasts; 0 for no limit in time
 * @param events how many events the trial lasts; 0 for no limit in their number
 * @param watches further checks
 * @since 0.1
 */
public record Probation(Duration time, long events, Watches watches) {
    /** No trial. */
    public static final Probation NONE = new Probation(Duration.ZERO, 0, (table, from) -> entry -> "");

    /** Creates watches. */
    @FunctionalInterface
    public interface Watches {
        /**
         * The models have taken over.
         *
         * @param table their decisions
         * @param from the states of device and evolved system
         */
        Watch begin(DecisionTable table, Configuration from);
    }

    /**
     * Checks each event that has ended.
     *
     * <p>Threading: called as a {@link ConverterListener} is.
     */
    @FunctionalInterface
    public interface Watch {
        /** Why the previous models have to come back, for people; empty if they need not. */
        String faultIn(HistoryEntry entry);
    }

    /** @throws IllegalArgumentException if time or number is less than 0 */
    public Probation {
        requireNonNull(watches, "the watches are null");
        if (time.isNegative() || events < 0) {
            throw new IllegalArgumentException(
                    "a probation of " + time + " and " + events + " events; neither may be less than 0");
        }
    }

    /** A trial of {@code time}. */
    public static Probation of(Duration time) {
        return new Probation(time, 0, NONE.watches());
    }

    /** A trial of this number of events. */
    public static Probation of(long events) {
        return new Probation(Duration.ZERO, events, NONE.watches());
    }

    /** A copy with these checks, too. */
    public Probation watchedBy(Watches others) {
        return new Probation(time, events, others);
    }

    /** Whether there is a trial. */
    public boolean isAny() {
        return !time.isZero() || events > 0;
    }
}
