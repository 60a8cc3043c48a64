package org.evoloop.converter;

import java.time.DayOfWeek;
import java.time.Duration;
import java.time.Instant;
import java.time.LocalDate;
import java.time.LocalTime;
import java.time.ZoneId;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import org.evoloop.evolution.EventNames;
import org.evoloop.statemachine.Event;
import org.evoloop.time.Clock;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A controller that raises events at fixed times of the day.
 *
 * <pre>{@code
 * converter.addMonitor(new TimetableMonitor("Timetable", ZoneId.systemDefault())
 *         .at(LocalTime.of(22, 0), "night")
 *         .at(LocalTime.of(6, 30), "morning")
 *         .at(LocalTime.of(10, 0), "clean", DayOfWeek.SATURDAY, DayOfWeek.SUNDAY));
 * }</pre>
 *
 * <p>A time that a day skips for summer time comes as much later, and one that a day has twice counts the first time. The time of
 * day is looked at once a minute at least, so a computer whose clock is set, or that has slept, tells what it has missed by
 * up to {@link #LATEST}; what is older is left out. Nothing is told twice, unless the clock goes back by more than that.
 *
 * <p>Threading: times are added before the converter is built.
 *
 * @since 0.1
 */
public final class TimetableMonitor extends PushMonitor {
    /** How late an event is still raised. */
    public static final Duration LATEST = Duration.ofHours(1);

    private static final Logger LOG = LoggerFactory.getLogger(TimetableMonitor.class);
    private static final Duration LONGEST_PAUSE = Duration.ofMinutes(1);

    private final ZoneId zone;
    private final List<Entry> entries = new CopyOnWriteArrayList<>();

    /** Up to when everything has been told; the clock's own. */
    private Instant told = Instant.MIN;

    private record Entry(LocalTime time, String event, Set<DayOfWeek> days) {}

    private record Due(Instant at, String event) {}

    /**
     * An empty timetable.
     *
     * @param name what the console calls it, unique within a converter
     * @param zone whose time of day counts
     */
    public TimetableMonitor(String name, ZoneId zone) {
        super(name);
        this.zone = zone;
    }

    /** Adds a time; without days it is every day's. */
    public TimetableMonitor at(LocalTime time, String event, DayOfWeek... days) {
        Set<DayOfWeek> wanted = EnumSet.allOf(DayOfWeek.class);
        if (days.length > 0) {
            wanted.retainAll(List.of(days));
        }
        entries.add(new Entry(time, event, wanted));
        return this;
    }

    /** @throws IllegalArgumentException if neither model knows one of the events */
    @Override
    void attached(EventNames names, Clock clock) {
        entries.forEach(entry -> names.require(new Event(entry.event())));
        told = clock.wallTime();
        wait(clock);
    }

    private void wait(Clock clock) {
        Instant now = clock.wallTime();
        List<Due> soon = between(now, now.plus(LONGEST_PAUSE));
        Duration pause = soon.isEmpty()
                ? LONGEST_PAUSE
                : Duration.between(now, soon.get(0).at());
        clock.schedule(pause, () -> look(clock));
    }

    private void look(Clock clock) {
        Instant now = clock.wallTime();
        if (isDetached()) {
            return;
        }
        if (now.isBefore(told.minus(LATEST))) {
            LOG.info("{}: the clock has gone back from {} to {}; it goes on from there", name(), told, now);
            told = now;
        }
        if (now.isAfter(told)) {
            Instant since = now.minus(LATEST);
            for (Due due : between(told.isBefore(since) ? since : told, now)) {
                push(fromController(due.event()));
            }
            told = now;
        }
        wait(clock);
    }

    /** What falls due after {@code begin} and not after {@code end}, at most some hours later; in order. */
    private List<Due> between(Instant begin, Instant end) {
        List<Due> due = new ArrayList<>();
        // A time that summer time skips may come on the next day.
        LocalDate day = begin.atZone(zone).toLocalDate().minusDays(1);
        for (LocalDate last = end.atZone(zone).toLocalDate(); !day.isAfter(last); day = day.plusDays(1)) {
            for (Entry entry : entries) {
                Instant at = day.atTime(entry.time()).atZone(zone).toInstant();
                if (entry.days().contains(day.getDayOfWeek()) && at.isAfter(begin) && !at.isAfter(end)) {
                    due.add(new Due(at, entry.event()));
                }
            }
        }
        due.sort(Comparator.comparing(Due::at));
        return due;
    }
}
