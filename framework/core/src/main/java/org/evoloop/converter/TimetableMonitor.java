package org.evoloop.converter;

import java.time.DayOfWeek;
import java.time.Instant;
import java.time.LocalTime;
import java.time.ZoneId;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import org.evoloop.evolution.EventNames;
import org.evoloop.statemachine.Event;
import org.evoloop.time.Clock;
import org.evoloop.time.TimesOfDay;
import org.jspecify.annotations.Nullable;
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
 * <p>It can be switched off, and one of its times can be left out, such as the next one.
 *
 * <p>For daylight saving time, a clock that is set and a computer that has slept, see {@link TimesOfDay}.
 *
 * <p>Threading: thread-safe. Times that are added while its converter runs count within a minute.
 *
 * @since 0.1
 */
public final class TimetableMonitor extends PushMonitor {
    /** All of the converter logs under one name. */
    private static final Logger LOG = LoggerFactory.getLogger("org.evoloop.converter.SystemEventConverter");

    private final ZoneId zone;
    private final List<Entry> entries = new CopyOnWriteArrayList<>();
    private @Nullable Clock clock;
    private volatile @Nullable TimesOfDay<String> times;
    private volatile boolean off;
    private volatile @Nullable Instant skipped;

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

    /**
     * Adds a time, on these days or, without any, on every day.
     *
     * @param event of one of the models
     */
    public synchronized TimetableMonitor at(LocalTime time, String event, DayOfWeek... days) {
        Set<DayOfWeek> wanted = EnumSet.allOf(DayOfWeek.class);
        if (days.length > 0) {
            wanted.retainAll(List.of(days));
        }
        entries.add(new Entry(time, wanted, event));
        arrange();
        return this;
    }

    /** Removes all times, so that others can be added. */
    public synchronized void clear() {
        entries.clear();
        arrange();
    }

    private void arrange() {
        Clock known = clock;
        if (known != null) {
            arranged(known);
        }
    }

    private TimesOfDay<String> arranged(Clock of) {
        TimesOfDay<String> made = new TimesOfDay<>(zone, of.wallTime());
        entries.forEach(entry -> made.add(entry.time(), entry.days(), entry.event()));
        times = made;
        return made;
    }

    /** Switches it off, so that it raises nothing, and on again; what it would have raised meanwhile does not come later. */
    public void setOn(boolean on) {
        off = !on;
    }

    /** Whether it raises events. */
    public boolean isOn() {
        return !off;
    }

    /**
     * Leaves one time out, at which it raises nothing; it need not be one of its times.
     *
     * @param time null to leave none out; another one takes the place of this one
     */
    public void skip(@Nullable Instant time) {
        skipped = time;
    }

    /** The time that is left out; empty if there is none, or if it is over. */
    public Optional<Instant> skipped(Instant now) {
        return Optional.ofNullable(skipped).filter(now::isBefore);
    }

    /**
     * When it raises its next event, within two weeks; empty if there is none, or if it is switched off.
     *
     * @param now by the converter's wall clock
     */
    public Optional<Instant> next(Instant now) {
        TimesOfDay<String> known = times;
        if (known == null || off) {
            return Optional.empty();
        }
        Optional<Instant> next = known.next(now);
        return next.isPresent() && next.equals(skipped(now)) ? known.next(next.get()) : next;
    }

    @Override
    void requireKnown(EventNames names) {
        entries.forEach(entry -> names.require(new Event(entry.event())));
    }

    /** @throws IllegalArgumentException if neither model knows one of the events */
    @Override
    synchronized void attached(EventNames names, Clock of) {
        requireKnown(names);
        clock = of;
        wait(arranged(of), of);
    }

    private void wait(TimesOfDay<String> known, Clock of) {
        of.schedule(known.pause(of.wallTime()), this::look);
    }

    private synchronized void look() {
        Clock of = clock;
        TimesOfDay<String> known = times;
        if (of == null || known == null || isDetached()) {
            return;
        }
        for (TimesOfDay.Due<String> due : known.due(of.wallTime())) {
            if (off || due.at().equals(skipped)) {
                LOG.info("{} at {} is skipped, as its owner asked", due.what(), due.at());
            } else {
                push(fromController(due.what()));
            }
        }
        wait(known, of);
    }
}
