package org.evoloop.mqtt.home;

import java.time.DayOfWeek;
import java.time.Instant;
import java.time.ZoneId;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import org.evoloop.converter.TimetableMonitor;
import org.evoloop.function.QuietHours;
import org.evoloop.time.Clock;
import org.evoloop.time.TimeOfWeek;

/**
 * When a converter raises events by itself, and when it must be quiet: what its owner changes in Home Assistant while it
 * runs.
 *
 * <pre>{@code
 * DayPlan day = new DayPlan(QuietHours.between(LocalTime.of(22, 0), LocalTime.of(7, 0)))
 *         .at("clean", "Clean at", List.of(TimeOfWeek.parse("Clean at", "MON,FRI 09:00")));
 * day.timetable().ifPresent(converter::addMonitor);
 * day.settings(clock, true).forEach(home::setting);
 * }</pre>
 *
 * <p>Threading: thread-safe, once its times have been added.
 *
 * @since 0.1
 */
public final class DayPlan {
    private final QuietHours quiet;
    private final TimetableMonitor timetable = new TimetableMonitor("Timetable", ZoneId.systemDefault());
    private final List<Daily> daily = new ArrayList<>();

    /** An event and its times. */
    private static final class Daily {
        private final String event;
        private final String label;
        private volatile List<TimeOfWeek> times;

        Daily(String event, String label, List<TimeOfWeek> times) {
            this.event = event;
            this.label = label;
            this.times = List.copyOf(times);
        }

        String text() {
            return times.stream().map(TimeOfWeek::toString).collect(Collectors.joining("; "));
        }
    }

    /** A plan without times. */
    public DayPlan(QuietHours quiet) {
        this.quiet = quiet;
    }

    /**
     * Adds an event that is raised at these times.
     *
     * @param label the name of these times for people, such as {@code Clean at}
     */
    public DayPlan at(String event, String label, List<TimeOfWeek> times) {
        daily.add(new Daily(event, label, times));
        arrange();
        return this;
    }

    /** When it is quiet. */
    public QuietHours quiet() {
        return quiet;
    }

    /** What raises the events; empty if there are none. */
    public Optional<TimetableMonitor> timetable() {
        return daily.isEmpty() ? Optional.empty() : Optional.of(timetable);
    }

    private synchronized void arrange() {
        timetable.clear();
        daily.forEach(each -> each.times.forEach(
                time -> timetable.at(time.time(), each.event, time.days().toArray(DayOfWeek[]::new))));
    }

    /**
     * What can be set.
     *
     * @param withQuietHours whether they are among it
     */
    public List<HomeSetting> settings(Clock clock, boolean withQuietHours) {
        List<HomeSetting> settings = new ArrayList<>();
        if (withQuietHours) {
            settings.add(
                    HomeSetting.time("Quiet from", quiet::from, quiet::begin).icon("mdi:weather-night"));
            settings.add(
                    HomeSetting.time("Quiet until", quiet::until, quiet::end).icon("mdi:weather-sunset-up"));
        }
        if (daily.isEmpty()) {
            return settings;
        }
        settings.add(
                HomeSetting.onOff("Schedule", timetable::isOn, timetable::setOn).icon("mdi:calendar-clock"));
        for (Daily each : daily) {
            settings.add(HomeSetting.text(each.label, each::text, text -> set(each, text))
                    .icon("mdi:clock-edit"));
        }
        settings.add(HomeSetting.onOff(
                        "Skip the next",
                        () -> timetable.skipped(clock.wallTime()).isPresent(),
                        skip -> skipNext(skip, clock.wallTime()))
                .icon("mdi:skip-next")
                .keptAs(
                        () -> timetable
                                .skipped(clock.wallTime())
                                .map(Instant::toString)
                                .orElse(""),
                        time -> timetable.skip(time.isEmpty() ? null : Instant.parse(time))));
        settings.add(HomeSetting.moment("Next start", () -> timetable.next(clock.wallTime())));
        return settings;
    }

    /** @param text the times, with a semicolon between them */
    private void set(Daily changed, String text) {
        changed.times = Arrays.stream(text.split(";", -1))
                .map(each -> TimeOfWeek.parse(changed.label, each.strip()))
                .toList();
        arrange();
    }

    private void skipNext(boolean skip, Instant now) {
        if (!skip) {
            timetable.skip(null);
        } else if (timetable.skipped(now).isEmpty()) {
            timetable.skip(timetable
                    .next(now)
                    .orElseThrow(() -> new IllegalStateException("the schedule is off, so there is nothing to skip")));
        }
    }
}
