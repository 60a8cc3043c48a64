package org.evoloop.converter;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.evoloop.Machines.machine;

import java.time.DayOfWeek;
import java.time.Duration;
import java.time.Instant;
import java.time.LocalTime;
import java.time.ZoneId;
import java.time.ZoneOffset;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Step;
import org.evoloop.loop.LoopConfig;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.time.SetClock;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** Events at fixed times of the day, when the clock is set and on days of 23 or 25 hours. */
class TimetableMonitorTest {
    private static final ZoneId BERLIN = ZoneId.of("Europe/Berlin");
    private static final Duration MINUTE = Duration.ofMinutes(1);

    private final SetClock clock = new SetClock();
    private final List<Instant> heard = new ArrayList<>();
    private TimetableMonitor timetable = daily(ZoneOffset.UTC);
    private @Nullable SystemEventConverter converter;

    private void begin(TimetableMonitor monitor) {
        timetable = monitor;
        StateMachine bell = machine("bell", "Hung ring -> Hung");
        converter = new SystemEventConverter(LoopConfig.defaults("bell", clock).withoutThreads());
        converter.addMonitor(timetable);
        converter.addExecute(new EventExecute("Bell") {
            @Override
            protected Set<String> sendableEvents() {
                return Set.of("ring");
            }

            @Override
            protected void send(Step step) {
                heard.add(clock.wallTime());
            }
        });
        converter.addKnowledge(new StateKnowledge(new ModelPair(bell, bell)));
        converter.build();
        converter.start();
    }

    private static TimetableMonitor daily(ZoneId zone, LocalTime... times) {
        TimetableMonitor timetable = new TimetableMonitor("Timetable", zone);
        for (LocalTime time : times) {
            timetable.at(time, "ring");
        }
        return timetable;
    }

    private void pass(Duration duration) throws InterruptedException {
        Duration left = duration;
        while (!left.isZero()) {
            Duration next = left.compareTo(MINUTE) < 0 ? left : MINUTE;
            clock.advance(next);
            do {
                converter.observe(timetable);
            } while (converter.step());
            left = left.minus(next);
        }
    }

    private static List<Instant> at(String... times) {
        return List.of(times).stream().map(Instant::parse).toList();
    }

    @AfterEach
    void close() {
        if (converter != null) {
            converter.close();
        }
    }

    @Test
    void ringsAtItsTimesEachDay() throws InterruptedException {
        clock.set("2026-11-23T05:59:00Z");
        begin(daily(ZoneOffset.UTC, LocalTime.of(6, 0), LocalTime.of(22, 0)));
        pass(Duration.ofDays(2));
        assertThat(heard)
                .isEqualTo(at(
                        "2026-11-23T06:00:00Z",
                        "2026-11-23T22:00:00Z",
                        "2026-11-24T06:00:00Z",
                        "2026-11-24T22:00:00Z"));
    }

    @Test
    void ringsOnItsDaysOnlyAndTwiceIfTwoTimesAreEqual() throws InterruptedException {
        // A Monday.
        clock.set("2026-11-23T00:00:00Z");
        begin(daily(ZoneOffset.UTC)
                .at(LocalTime.NOON, "ring", DayOfWeek.TUESDAY)
                .at(LocalTime.NOON, "ring", DayOfWeek.TUESDAY));
        pass(Duration.ofDays(7));
        assertThat(heard).isEqualTo(at("2026-11-24T12:00:00Z", "2026-11-24T12:00:00Z"));
    }

    @Test
    void theNextTimeIsLeftOutAndThoseAfterItAreNot() throws InterruptedException {
        clock.set("2026-11-23T05:59:00Z");
        begin(daily(ZoneOffset.UTC, LocalTime.of(6, 0), LocalTime.of(22, 0)));
        timetable.skip(timetable.next(clock.wallTime()).orElseThrow());
        assertThat(timetable.skipped(clock.wallTime())).contains(Instant.parse("2026-11-23T06:00:00Z"));
        assertThat(timetable.next(clock.wallTime())).contains(Instant.parse("2026-11-23T22:00:00Z"));
        pass(Duration.ofHours(2));
        assertThat(timetable.skipped(clock.wallTime())).isEmpty();
        pass(Duration.ofDays(1));
        assertThat(heard).isEqualTo(at("2026-11-23T22:00:00Z", "2026-11-24T06:00:00Z"));
    }

    @Test
    void whatASwitchedOffTimetableWouldHaveRungIsNotMadeUpFor() throws InterruptedException {
        clock.set("2026-11-23T05:59:00Z");
        begin(daily(ZoneOffset.UTC, LocalTime.of(6, 0)));
        timetable.setOn(false);
        assertThat(timetable.next(clock.wallTime())).isEmpty();
        pass(Duration.ofMinutes(30));
        timetable.setOn(true);
        pass(Duration.ofDays(1));
        assertThat(heard).isEqualTo(at("2026-11-24T06:00:00Z"));
    }

    @Test
    void theNextTimeMayBeOnAnotherDay() {
        // A Monday.
        clock.set("2026-11-23T13:00:00Z");
        begin(daily(ZoneOffset.UTC).at(LocalTime.NOON, "ring", DayOfWeek.MONDAY));
        assertThat(timetable.next(clock.wallTime())).contains(Instant.parse("2026-11-30T12:00:00Z"));
        timetable.skip(Instant.parse("2026-11-30T12:00:00Z"));
        assertThat(timetable.next(clock.wallTime())).contains(Instant.parse("2026-12-07T12:00:00Z"));
    }

    @Test
    void whatHadComeBeforeTheStartIsNotMadeUpFor() throws InterruptedException {
        clock.set("2026-11-23T06:00:00Z");
        begin(daily(ZoneOffset.UTC, LocalTime.of(6, 0)));
        pass(Duration.ofHours(1));
        assertThat(heard).isEmpty();
    }

    @Test
    void aTimeThatSummerTimeSkipsComesLaterAndOneThatItRepeatsComesOnce() throws InterruptedException {
        clock.set("2026-03-28T12:00:00Z");
        begin(daily(BERLIN, LocalTime.of(2, 30)));
        pass(Duration.ofDays(1));
        assertThat(heard).isEqualTo(at("2026-03-29T01:30:00Z"));
        heard.clear();

        clock.set("2026-10-24T12:00:00Z");
        pass(Duration.ofDays(1));
        assertThat(heard).isEqualTo(at("2026-10-25T00:30:00Z"));
    }

    @Test
    void aClockThatIsSetForwardReportsWhatItSkippedUnlessThatIsOld() throws InterruptedException {
        clock.set("2026-11-23T05:00:00Z");
        begin(daily(ZoneOffset.UTC, LocalTime.of(6, 0), LocalTime.of(7, 0), LocalTime.of(7, 30)));
        clock.set("2026-11-23T07:45:00Z");
        pass(MINUTE);
        assertThat(heard).isEqualTo(at("2026-11-23T07:46:00Z", "2026-11-23T07:46:00Z"));
    }

    @Test
    void aClockThatIsSetBackRingsNothingTwiceUnlessItIsSetBackFar() throws InterruptedException {
        clock.set("2026-11-23T05:59:00Z");
        begin(daily(ZoneOffset.UTC, LocalTime.of(6, 0)));
        pass(MINUTE);
        clock.set("2026-11-23T05:30:00Z");
        pass(Duration.ofHours(1));
        assertThat(heard).hasSize(1);

        clock.set("2026-11-20T05:30:00Z");
        pass(Duration.ofHours(1));
        assertThat(heard).hasSize(2);
    }

    @Test
    void whenItsConverterIsClosedTheTimetableHoldsNothing() {
        clock.set("2026-11-23T05:00:00Z");
        begin(daily(ZoneOffset.UTC, LocalTime.of(6, 0)));
        converter.close();
        clock.advance(MINUTE);
        assertThat(clock.pendingTasks()).isZero();
    }

    @Test
    void anUnknownEventIsRefusedWhenTheConverterIsBuilt() {
        assertThatThrownBy(() -> begin(daily(ZoneOffset.UTC).at(LocalTime.NOON, "rings")))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("unknown event rings; did you mean ring?");
    }
}
