package org.evoloop.function;

import java.time.Duration;
import java.time.Instant;
import java.time.LocalTime;
import java.time.ZoneId;
import java.time.ZonedDateTime;

/**
 * The hours of the day in which a system must not start something by itself. Its owner may change them while it runs.
 *
 * <p>Threading: thread-safe.
 *
 * @since 0.1
 */
public final class QuietHours {
    private static final Duration LOOK = Duration.ofMinutes(1);

    private final ZoneId zone;
    private volatile Hours hours;

    /**
     * What they are.
     *
     * @param from the start of the quiet hours
     * @param until the end, exclusive; the same as {@code from} for no quiet hours
     */
    private record Hours(LocalTime from, LocalTime until) {}

    private QuietHours(LocalTime from, LocalTime until) {
        this.zone = ZoneId.systemDefault();
        this.hours = new Hours(from, until);
    }

    /** No quiet hours. */
    public static QuietHours none() {
        return between(LocalTime.MIDNIGHT, LocalTime.MIDNIGHT);
    }

    /**
     * Quiet hours in this computer's time zone.
     *
     * @param from their start
     * @param until their end, exclusive, on the next day if that is earlier; the same as {@code from} for none
     */
    public static QuietHours between(LocalTime from, LocalTime until) {
        return new QuietHours(from, until);
    }

    /** Their start. */
    public LocalTime from() {
        return hours.from();
    }

    /** Their end. */
    public LocalTime until() {
        return hours.until();
    }

    /** Changes their start. */
    public void begin(LocalTime from) {
        hours = new Hours(from, hours.until());
    }

    /** Changes their end. */
    public void end(LocalTime until) {
        hours = new Hours(hours.from(), until);
    }

    /** Whether it is quiet now. */
    public boolean isQuiet(Instant now) {
        return !left(now.atZone(zone)).isZero();
    }

    /** The remaining time; zero outside the quiet hours. */
    public Duration left(ZonedDateTime now) {
        Hours known = hours;
        LocalTime from = known.from();
        LocalTime until = known.until();
        LocalTime time = now.toLocalTime();
        boolean within = from.isBefore(until)
                ? !time.isBefore(from) && time.isBefore(until)
                : !from.equals(until) && (!time.isBefore(from) || time.isBefore(until));
        if (!within) {
            return Duration.ZERO;
        }
        ZonedDateTime end = now.with(until);
        return Duration.between(now, end.isAfter(now) ? end : now.plusDays(1).with(until));
    }

    /**
     * A function that waits until they end, and finishes with {@code event}; at once outside these hours. That they were
     * changed meanwhile counts within a minute.
     */
    public NewFunction waiting(String event) {
        return visit -> look(visit, event);
    }

    private void look(Visit visit, String event) {
        Duration left = left(visit.clock().wallTime().atZone(zone));
        if (left.compareTo(LOOK) <= 0) {
            visit.finishAfter(left, event);
        } else {
            visit.progress("waiting until " + until());
            visit.after(LOOK, () -> look(visit, event));
        }
    }
}
