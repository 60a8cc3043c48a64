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
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * What falls due at times of the day.
 *
 * <p>A time that a day skips for summer time comes as much later, and one that a day has twice counts the first time. Whoever looks
 * after each {@link #pause} finds out soon that the computer's clock was set, or that the computer has slept: what was missed by
 * up to {@link #LATEST} is due then, what is older is left out, and nothing is due twice, unless the clock goes back by more than
 * that.
 *
 * <p>Threading: times are added before the first look; one thread at a time looks.
 *
 * @param <T> what is due
 * @since 0.1
 */
public final class TimesOfDay<T> {
    /** How late something is still due. */
    public static final Duration LATEST = Duration.ofHours(1);

    private static final Logger LOG = LoggerFactory.getLogger(TimesOfDay.class);
    private static final Duration LONGEST_PAUSE = Duration.ofMinutes(1);

    private final ZoneId zone;
    private final List<Entry<T>> entries = new CopyOnWriteArrayList<>();

    /** Up to when everything has been due; the clock's own. */
    private Instant told;

    private record Entry<T>(LocalTime time, Set<DayOfWeek> days, T what) {}

    private record Due<T>(Instant at, T what) {}

    /**
     * No times.
     *
     * @param zone whose time of day counts
     * @param now what has come up to then is not made up for
     */
    public TimesOfDay(ZoneId zone, Instant now) {
        this.zone = zone;
        this.told = now;
    }

    /** Adds a time of these days of the week. */
    public void add(LocalTime time, Set<DayOfWeek> days, T what) {
        entries.add(new Entry<>(time, Set.copyOf(days), what));
    }

    /** How long to wait before the next look: until something is due, but a minute at most. */
    public Duration pause(Instant now) {
        List<Due<T>> soon = between(now, now.plus(LONGEST_PAUSE));
        return soon.isEmpty()
                ? LONGEST_PAUSE
                : Duration.between(now, soon.get(0).at());
    }

    /** What has become due since the last look, in order. */
    public List<T> due(Instant now) {
        if (now.isBefore(told.minus(LATEST))) {
            LOG.info("the clock has gone back from {} to {}; times of the day go on from there", told, now);
            told = now;
        }
        if (!now.isAfter(told)) {
            return List.of();
        }
        Instant since = now.minus(LATEST);
        List<Due<T>> due = between(told.isBefore(since) ? since : told, now);
        told = now;
        return due.stream().map(Due::what).toList();
    }

    /** What falls due after {@code begin} and not after {@code end}, at most some hours later; in order. */
    private List<Due<T>> between(Instant begin, Instant end) {
        List<Due<T>> due = new ArrayList<>();
        // A time that summer time skips may come on the next day.
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
