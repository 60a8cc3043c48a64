package org.evoloop.roomba;

import java.time.Instant;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import org.evoloop.converter.TimetableMonitor;
import org.evoloop.mqtt.home.HomeSetting;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;

/**
 * When the robot cleans, and when it must not: what its owner changes in Home Assistant while it runs.
 *
 * <p>Threading: thread-safe.
 */
final class DayPlan {
    private final QuietHours quiet;
    private final @Nullable TimetableMonitor timetable;
    private volatile List<Timetable> times;

    private DayPlan(QuietHours quiet, @Nullable TimetableMonitor timetable, List<Timetable> times) {
        this.quiet = quiet;
        this.timetable = timetable;
        this.times = times;
    }

    /** Without times there is no timetable: then the robot has its own. */
    static DayPlan of(QuietHours quiet, List<Timetable> times) {
        return new DayPlan(quiet, times.isEmpty() ? null : Timetable.monitor(times), times);
    }

    QuietHours quiet() {
        return quiet;
    }

    /** Null if there are no times. */
    @Nullable
    TimetableMonitor timetable() {
        return timetable;
    }

    /**
     * What can be set.
     *
     * @param waits whether the new model waits for the end of the quiet hours
     */
    List<HomeSetting> settings(Clock clock, boolean waits) {
        List<HomeSetting> settings = new ArrayList<>();
        if (waits) {
            settings.add(
                    HomeSetting.time("Quiet from", quiet::from, quiet::begin).icon("mdi:weather-night"));
            settings.add(
                    HomeSetting.time("Quiet until", quiet::until, quiet::end).icon("mdi:weather-sunset-up"));
        }
        TimetableMonitor monitor = timetable;
        if (monitor != null) {
            settings.add(
                    HomeSetting.onOff("Schedule", monitor::isOn, monitor::setOn).icon("mdi:calendar-clock"));
            settings.add(HomeSetting.text("Clean at", this::text, text -> clean(monitor, text))
                    .icon("mdi:clock-edit"));
            settings.add(HomeSetting.onOff(
                            "Skip the next",
                            () -> monitor.skipped(clock.wallTime()).isPresent(),
                            skip -> skipNext(monitor, skip, clock.wallTime()))
                    .icon("mdi:skip-next")
                    .keptAs(
                            () -> monitor.skipped(clock.wallTime())
                                    .map(Instant::toString)
                                    .orElse(""),
                            time -> monitor.skip(time.isEmpty() ? null : Instant.parse(time))));
            settings.add(HomeSetting.moment("Next start", () -> monitor.next(clock.wallTime())));
        }
        return settings;
    }

    private String text() {
        return times.stream().map(Timetable::toString).collect(Collectors.joining("; "));
    }

    /** @param text the times, with a semicolon between them */
    private void clean(TimetableMonitor monitor, String text) {
        List<Timetable> wanted = Arrays.stream(text.split(";", -1))
                .map(each -> Timetable.parse("Clean at", each.strip()))
                .toList();
        monitor.clear();
        wanted.forEach(each -> each.addTo(monitor));
        times = wanted;
    }

    private static void skipNext(TimetableMonitor monitor, boolean skip, Instant now) {
        if (!skip) {
            monitor.skip(null);
        } else if (monitor.skipped(now).isEmpty()) {
            monitor.skip(monitor.next(now)
                    .orElseThrow(() -> new IllegalStateException("the schedule is off, so there is nothing to skip")));
        }
    }
}
