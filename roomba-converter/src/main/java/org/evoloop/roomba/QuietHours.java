package org.evoloop.roomba;

import java.time.Duration;
import java.time.LocalTime;
import java.time.ZoneId;
import java.time.ZonedDateTime;
import java.time.format.DateTimeParseException;
import org.evoloop.function.NewFunction;
import org.evoloop.function.Visit;

/**
 * The hours of the day in which the robot must not start by itself, and the new function that waits until they end: it
 * then raises {@code quietOver}, or at once outside these hours. The owner may change them meanwhile, which counts within
 * a minute.
 *
 * <p>Threading: thread-safe.
 */
final class QuietHours implements NewFunction {
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
    static QuietHours none() {
        return new QuietHours(LocalTime.MIDNIGHT, LocalTime.MIDNIGHT);
    }

    /**
     * Parses a text such as {@code 22:00-07:00}.
     *
     * @throws IllegalArgumentException if the text has another form
     */
    static QuietHours parse(String text) {
        String[] parts = text.split("-", -1);
        try {
            if (parts.length == 2) {
                return new QuietHours(LocalTime.parse(parts[0].strip()), LocalTime.parse(parts[1].strip()));
            }
        } catch (DateTimeParseException wrong) {
            // Reported below, as for any other text.
        }
        throw new IllegalArgumentException(
                "--quiet-hours is " + text + "; give two times of day, for example 22:00-07:00");
    }

    LocalTime from() {
        return hours.from();
    }

    LocalTime until() {
        return hours.until();
    }

    /** Changes their start. */
    void begin(LocalTime from) {
        hours = new Hours(from, hours.until());
    }

    /** Changes their end. */
    void end(LocalTime until) {
        hours = new Hours(hours.from(), until);
    }

    /** The remaining time; zero outside the quiet hours. */
    Duration left(ZonedDateTime now) {
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

    @Override
    public void run(Visit visit) {
        Duration left = left(visit.clock().wallTime().atZone(zone));
        if (left.compareTo(LOOK) <= 0) {
            visit.finishAfter(left, RobotEvents.QUIET_OVER);
        } else {
            visit.progress("waiting until " + until());
            visit.after(LOOK, () -> run(visit));
        }
    }
}
