package org.evoloop.function.visit;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import java.time.LocalTime;
import java.time.ZoneId;
import java.time.ZoneOffset;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** What a visit does at a time of day, with daylight saving time and when the clock is set. */
class AlarmTest {
    private static final ZoneId BERLIN = ZoneId.of("Europe/Berlin");

    private final VisitLog log = new VisitLog(false);
    private final HostedVisit visit = log.visit();
    private final List<Instant> rung = new ArrayList<>();

    private void ring() {
        rung.add(log.clock.wallTime());
    }

    private void assertRung(String... times) {
        assertThat(rung).isEqualTo(List.of(times).stream().map(Instant::parse).toList());
        rung.clear();
    }

    @Test
    void onceAndEveryDay() {
        log.clock.set("2026-11-23T06:00:00Z");
        visit.at(LocalTime.of(6, 30), ZoneOffset.UTC, this::ring);
        visit.daily(LocalTime.of(6, 0), ZoneOffset.UTC, this::ring);
        log.clock.advance(Duration.ofDays(2));
        assertRung("2026-11-23T06:30:00Z", "2026-11-24T06:00:00Z", "2026-11-25T06:00:00Z");
    }

    @Test
    void aTimeOfTheComputersOwnZoneComesOnceInADay() {
        log.clock.set("2026-11-23T00:00:00Z");
        visit.at(LocalTime.NOON, this::ring);
        visit.daily(LocalTime.NOON, this::ring);
        visit.finishAt(LocalTime.NOON, "timeout");
        log.clock.advance(Duration.ofDays(1).plusHours(1));
        assertThat(rung).hasSizeBetween(2, 3);
        assertThat(log.events).containsExactly("finished timeout");
    }

    @Test
    void aTimeThatSummerTimeSkipsComesLaterAndOneThatItRepeatsComesOnce() {
        log.clock.set("2026-03-28T12:00:00Z");
        visit.daily(LocalTime.of(2, 30), BERLIN, this::ring);
        log.clock.advance(Duration.ofDays(1));
        assertRung("2026-03-29T01:30:00Z");
        log.clock.set("2026-10-24T12:00:00Z");
        log.clock.advance(Duration.ofDays(2));
        assertRung("2026-10-25T00:30:00Z", "2026-10-26T01:30:00Z");
    }

    @Test
    void aClockThatIsSetForwardOrBackIsFollowed() {
        log.clock.set("1970-01-01T00:00:00Z");
        visit.daily(LocalTime.of(22, 0), ZoneOffset.UTC, this::ring);
        log.clock.set("2026-11-23T21:59:30Z");
        log.clock.advance(Duration.ofMinutes(2));
        assertThat(rung).hasSize(1);
        log.clock.set("2026-11-23T21:58:00Z");
        log.clock.advance(Duration.ofMinutes(10));
        assertThat(rung).as("not twice, though the clock went back by minutes").hasSize(1);
        rung.clear();
        log.clock.set("2026-11-24T23:30:00Z");
        log.clock.advance(Duration.ofMinutes(5));
        assertThat(rung).as("more than an hour late").isEmpty();
        log.clock.set("2026-11-25T22:30:00Z");
        log.clock.advance(Duration.ofMinutes(1));
        assertThat(rung).as("half an hour late").hasSize(1);
    }

    @Test
    void whenTheStateIsLeftNothingWaits() {
        visit.at(LocalTime.NOON, ZoneOffset.UTC, this::ring);
        visit.daily(LocalTime.NOON, ZoneOffset.UTC, this::ring);
        visit.finishAt(LocalTime.NOON, ZoneOffset.UTC, "timeout");
        log.clock.advance(Duration.ofHours(1));
        visit.end();
        assertThat(log.clock.pendingTasks()).isZero();
        visit.daily(LocalTime.NOON, ZoneOffset.UTC, this::ring);
        assertThat(log.clock.pendingTasks()).isZero();
    }
}
