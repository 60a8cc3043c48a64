package org.evoloop.function.visit;

import java.time.DayOfWeek;
import java.time.LocalTime;
import java.time.ZoneId;
import java.util.EnumSet;
import org.evoloop.time.Clock;
import org.evoloop.time.TimesOfDay;

/**
 * A task that a visit runs at a time of day.
 *
 * <p>Threading: the clock's thread checks the time as long as the visit lasts.
 */
final class Alarm {
    private final HostedVisit visit;
    private final Clock clock;
    private final TimesOfDay<Runnable> times;

    Alarm(HostedVisit visit, LocalTime time, ZoneId zone, Runnable task) {
        this.visit = visit;
        this.clock = visit.clock();
        this.times = new TimesOfDay<>(zone, clock.wallTime());
        times.add(time, EnumSet.allOf(DayOfWeek.class), task);
    }

    void once() {
        wait(false);
    }

    void daily() {
        wait(true);
    }

    private void wait(boolean again) {
        visit.onClock(times.pause(clock.wallTime()), () -> look(again));
    }

    private void look(boolean again) {
        var due = times.due(clock.wallTime());
        if (due.isEmpty() || again) {
            wait(again);
        }
        due.forEach(each -> each.what().run());
    }
}
