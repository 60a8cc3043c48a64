package org.evoloop.converter;

import static java.util.Objects.requireNonNull;

import java.time.Duration;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.DecisionTable;

/**
 * How long other models are on trial after they have taken over. The models before them come back if meanwhile an event
 * fails, the record of the device is in doubt, the device is found elsewhere than the record says, or a watch reports a violation.
 *
 * <p>Threading: immutable.
 *
 * @param time after which the trial is over; 0 for no end by time
 * @param events after which it is over; 0 for no end by their number
 * @param watches what else is looked at
 * @since 0.1
 */
public record Probation(Duration time, long events, Watches watches) {
    /** No trial. */
    public static final Probation NONE = new Probation(Duration.ZERO, 0, (table, from) -> entry -> "");

    /** Begins to watch. */
    @FunctionalInterface
    public interface Watches {
        /**
         * The models have taken over.
         *
         * @param table what they make of events
         * @param from where device and evolved system are
         */
        Watch begin(DecisionTable table, Configuration from);
    }

    /**
     * Looks at each event that has come to its end.
     *
     * <p>Threading: called as a {@link ConverterListener} is.
     */
    @FunctionalInterface
    public interface Watch {
        /** Why the models before have to come back, for people; empty if they need not. */
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

    /** A trial of so many events. */
    public static Probation of(long events) {
        return new Probation(Duration.ZERO, events, NONE.watches());
    }

    /** The same, looked at by these, too. */
    public Probation watchedBy(Watches others) {
        return new Probation(time, events, others);
    }

    /** Whether there is a trial. */
    public boolean isAny() {
        return !time.isZero() || events > 0;
    }
}
