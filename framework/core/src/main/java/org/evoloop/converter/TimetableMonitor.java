package org.evoloop.converter;

import java.time.DayOfWeek;
import java.time.LocalTime;
import java.time.ZoneId;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import org.evoloop.evolution.EventNames;
import org.evoloop.statemachine.Event;
import org.evoloop.time.Clock;
import org.evoloop.time.TimesOfDay;

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
 * <p>For daylight saving time, a clock that is set and a computer that has slept, see {@link TimesOfDay}.
 *
 * <p>Threading: times are added before the converter is built.
 *
 * @since 0.1
 */
public final class TimetableMonitor extends PushMonitor {
    private final ZoneId zone;
    private final List<Entry> entries = new CopyOnWriteArrayList<>();

    private record Entry(LocalTime time, Set<DayOfWeek> days, String event) {}

    /**
     * An empty timetable.
     *
     * @param name its name in the console, unique within a converter
     * @param zone the time zone of the times
     */
    public TimetableMonitor(String name, ZoneId zone) {
        super(name);
        this.zone = zone;
    }

    /** Adds a time, on these days or, without any, on every day. */
    public TimetableMonitor at(LocalTime time, String event, DayOfWeek... days) {
        Set<DayOfWeek> wanted = EnumSet.allOf(DayOfWeek.class);
        if (days.length > 0) {
            wanted.retainAll(List.of(days));
        }
        entries.add(new Entry(time, wanted, event));
        return this;
    }

    @Override
    void requireKnown(EventNames names) {
        entries.forEach(entry -> names.require(new Event(entry.event())));
    }

    /** @throws IllegalArgumentException if neither model knows one of the events */
    @Override
    void attached(EventNames names, Clock clock) {
        requireKnown(names);
        TimesOfDay<String> times = new TimesOfDay<>(zone, clock.wallTime());
        entries.forEach(entry -> times.add(entry.time(), entry.days(), entry.event()));
        wait(times, clock);
    }

    private void wait(TimesOfDay<String> times, Clock clock) {
        clock.schedule(times.pause(clock.wallTime()), () -> look(times, clock));
    }

    private void look(TimesOfDay<String> times, Clock clock) {
        if (isDetached()) {
            return;
        }
        times.due(clock.wallTime()).forEach(event -> push(fromController(event)));
        wait(times, clock);
    }
}
