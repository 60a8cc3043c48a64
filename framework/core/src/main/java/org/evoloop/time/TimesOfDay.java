package org.evoloop.time;

import java.time.DayOfWeek;
import java.time.Duration;
import java.time.Instant;
import java.time.LocalDate;
import java.time.LocalTime;
import java.time.ZoneId;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A schedule by time of day.
 *
 * <p>A time that a day skips for daylight saving time comes later by the same amount, and of a time that occurs twice
 * the first counts. A caller that checks after each {@link #pause} soon notices that the computer's clock was set, or
 * that the computer has slept: items missed by up to {@link #LATEST} are due then, older ones are skipped, and nothing
 * is due twice, unless the clock goes back by more than that.
 *
 * <p>Threading: times are added before the first check; one thread at a time checks.
 *
 * @param <T> an item that becomes due
 * @since 0.1
 */
public final class TimesOfDay<T> {
    /** How late an item is still due. */
    public static final Duration LATEST = Duration.ofHours(1);

    private static final Logger LOG = LoggerFactory.getLogger(TimesOfDay.class);
    private static final Duration LONGEST_PAUSE = Duration.ofMinutes(1);
    private static final Duration FORESIGHT = Duration.ofDays(14);

    private final ZoneId zone;
    private final List<Entry<T>> entries = new CopyOnWriteArrayList<>();

    /** The time up to which everything has been returned. */
    private Instant returned;

    private record Entry<T>(LocalTime time, Set<DayOfWeek> days, T what) {}

    /**
     * An item that is due.
     *
     * @param at when
     * @param what the item
     */
    public record Due<T>(Instant at, T what) {}

    /**
     * An empty schedule.
     *
     * @param zone the time zone of the times
     * @param now the present time; earlier items are skipped
     */
    public TimesOfDay(ZoneId zone, Instant now) {
        this.zone = zone;
        this.returned = now;
    }

    /** Adds a time on these days of the week. */
    public void add(LocalTime time, Set<DayOfWeek> days, T what) {
        entries.add(new Entry<>(time, Set.copyOf(days), what));
    }

    /** How long to wait before the next check: until an item is due, but at most a minute. */
    public Duration pause(Instant now) {
        List<Due<T>> soon = between(now, now.plus(LONGEST_PAUSE));
        return soon.isEmpty()
                ? LONGEST_PAUSE
                : Duration.between(now, soon.get(0).at());
    }

    /** When the next item after {@code now} is due, within two weeks; empty if there is none. */
    public Optional<Instant> next(Instant now) {
        return between(now, now.plus(FORESIGHT)).stream().map(Due::at).findFirst();
    }

    /** The items that have become due since the last check, in order. */
    public List<Due<T>> due(Instant now) {
        if (now.isBefore(returned.minus(LATEST))) {
            LOG.info("the clock has gone back from {} to {}; times of the day go on from there", returned, now);
            returned = now;
        }
        if (!now.isAfter(returned)) {
            return List.of();
        }
        Instant since = now.minus(LATEST);
        List<Due<T>> due = between(returned.isBefore(since) ? since : returned, now);
        returned = now;
        return due;
    }

    /** The items due after {@code begin} and not after {@code end}; in order. */
    private List<Due<T>> between(Instant begin, Instant end) {
        List<Due<T>> due = new ArrayList<>();
        // A time skipped for daylight saving time may come on the next day.
        LocalDate day = begin.atZone(zone).toLocalDate().minusDays(1);
        for (LocalDate last = end.atZone(zone).toLocalDate(); !day.isAfter(last); day = day.plusDays(1)) {
            for (Entry<T> entry : entries) {
                Instant at = day.atTime(entry.time()).atZone(zone).toInstant();
                if (entry.days().contains(day.getDayOfWeek()) && at.isAfter(begin) && !at.isAfter(end)) {
                    due.add(new Due<>(at, entry.what()));
                }
            }
        }
        due.sort(Comparator.comparing(Due::at));
        return due;
    }
}
