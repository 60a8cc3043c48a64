package org.evoloop.converter;

import java.time.Duration;

/**
 * How long other models are on trial after they have taken over. The models before them come back if meanwhile an event
 * fails, the record of the device is in doubt, the device is found elsewhere than the record says, or a watch tells so.
 *
 * <p>Threading: immutable.
 *
 * @param time after which the trial is over; 0 for no end by time
 * @param events after which it is over; 0 for no end by their number
 * @param watch what else is looked at
 * @since 0.1
 */
public record Probation(Duration time, long events, Watch watch) {
    /** No trial. */
    public static final Probation NONE = new Probation(Duration.ZERO, 0, entry -> "");

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

    public Probation {
        if (time.isNegative() || events < 0) {
            throw new IllegalArgumentException(
                    "a probation of " + time + " and " + events + " events; neither may be less than 0");
        }
    }

    /** A trial of {@code time}. */
    public static Probation of(Duration time) {
        return new Probation(time, 0, NONE.watch());
    }

    /** A trial of so many events. */
    public static Probation of(long events) {
        return new Probation(Duration.ZERO, events, NONE.watch());
    }

    /** The same, looked at by {@code another}, too. */
    public Probation watchedBy(Watch another) {
        return new Probation(time, events, another);
    }

    /** Whether there is a trial. */
    public boolean isAny() {
        return !time.isZero() || events > 0;
    }
}
