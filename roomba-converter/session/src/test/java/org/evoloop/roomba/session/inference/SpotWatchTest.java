package org.evoloop.roomba.session.inference;

import static org.assertj.core.api.Assertions.assertThat;
import static org.evoloop.roomba.session.Frames.cleaning;
import static org.evoloop.roomba.session.Frames.encoders;
import static org.evoloop.roomba.session.Frames.resting;

import org.evoloop.roomba.oi.OiMode;
import org.evoloop.roomba.oi.Packet;
import org.evoloop.roomba.oi.SensorValues;
import org.evoloop.roomba.session.Frames;
import org.evoloop.roomba.session.inference.SpotWatch.SpotEnd;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;

class SpotWatchTest {
    private static final SensorValues REST = resting(OiMode.PASSIVE);

    private final SpotWatch watch = new SpotWatch();
    private long nowNanos;

    private @Nullable SpotEnd update(SensorValues frame) {
        nowNanos += Frames.APART_NANOS;
        return watch.update(frame, nowNanos);
    }

    /** Feeds the same frame this many times; only the last one may bring the ending. */
    private @Nullable SpotEnd feed(SensorValues frame, int times) {
        for (int i = 1; i < times; i++) {
            assertThat(update(frame)).as("frame %d of %d", i, times).isNull();
        }
        return update(frame);
    }

    @Test
    void reportsNothingWithoutASpotCleaning() {
        assertThat(feed(cleaning(), 500)).isNull();
        assertThat(feed(REST, 500)).isNull();
    }

    @Test
    void endsOnceAllHasBeenQuietForASecond() {
        watch.started();
        assertThat(feed(REST, 30)).isNull();
        assertThat(feed(cleaning(), 2_000)).isNull();
        assertThat(feed(REST, SpotWatch.QUIET_FRAMES)).isEqualTo(SpotEnd.QUIET);
        assertThat(feed(REST, 500)).as("only once").isNull();
    }

    @Test
    void aPauseOfLessThanASecondIsNotTheEnd() {
        watch.started();
        for (int bumps = 0; bumps < 20; bumps++) {
            assertThat(feed(cleaning(), 50)).isNull();
            assertThat(feed(REST, SpotWatch.QUIET_FRAMES - 1)).isNull();
        }
    }

    @Test
    void anySignOfLifeIsEnough() {
        for (SensorValues alive : new SensorValues[] {
            REST.with(Packet.CURRENT, Motion.MOVING_CURRENT_MILLI_AMPS - 1),
            REST.with(Packet.MAIN_BRUSH_CURRENT, Motion.BRUSH_CURRENT_MILLI_AMPS + 1),
            REST.with(Packet.SIDE_BRUSH_CURRENT, -Motion.BRUSH_CURRENT_MILLI_AMPS - 1),
        }) {
            watch.started();
            assertThat(feed(alive, 10)).isNull();
            assertThat(feed(REST, SpotWatch.QUIET_FRAMES)).as("%s", alive).isEqualTo(SpotEnd.QUIET);
        }
        watch.started();
        for (int counts = 0; counts < 300; counts++) {
            assertThat(update(encoders(counts, -counts))).isNull();
        }
        assertThat(feed(encoders(299, -299), SpotWatch.QUIET_FRAMES)).isEqualTo(SpotEnd.QUIET);
    }

    @Test
    void aRobotThatNeverBeginsIsReported() {
        watch.started();
        assertThat(feed(REST, SpotWatch.START_FRAMES)).isEqualTo(SpotEnd.NOT_STARTED);
        assertThat(feed(REST, 500)).isNull();
    }

    @Test
    void movingUnderControlIsNotASpotCleaning() {
        watch.started();
        SensorValues driven = resting(OiMode.SAFE).with(Packet.CURRENT, -900);
        assertThat(feed(driven, SpotWatch.START_FRAMES)).isEqualTo(SpotEnd.NOT_STARTED);
    }

    @Test
    void controlTakenByAClientEndsItAtOnce() {
        watch.started();
        feed(cleaning(), 100);
        assertThat(update(cleaning().with(Packet.OI_MODE, OiMode.SAFE.code()))).isEqualTo(SpotEnd.OVERRIDDEN);
    }

    @Test
    void noneLastsLongerThanThreeMinutes() {
        watch.started();
        assertThat(feed(cleaning(), SpotWatch.LONGEST_FRAMES)).isEqualTo(SpotEnd.TOO_LONG);
    }

    @Test
    void lostFramesMakeItLateNeverEarly() {
        watch.started();
        feed(cleaning(), 100);
        // Every second frame is lost. Received frames are counted, so the second of rest takes two seconds.
        int seen = 0;
        SpotEnd ending = null;
        for (int frame = 0; ending == null; frame++) {
            if (frame % 2 == 0) {
                ending = update(REST);
                seen++;
            }
        }
        assertThat(seen).isEqualTo(SpotWatch.QUIET_FRAMES);
    }

    @Test
    void oldFramesThatComeAtOnceDoNotMeanThatItNeverStarted() {
        watch.started();
        for (int frame = 0; frame < 2 * SpotWatch.START_FRAMES; frame++) {
            assertThat(watch.update(REST, nowNanos)).isNull();
        }
        assertThat(feed(cleaning(), 100)).isNull();
        assertThat(feed(REST, SpotWatch.QUIET_FRAMES)).isEqualTo(SpotEnd.QUIET);
    }

    @Test
    void aSecondStartBeginsAnew() {
        watch.started();
        feed(cleaning(), 100);
        feed(REST, SpotWatch.QUIET_FRAMES - 1);
        watch.started();
        assertThat(feed(REST, SpotWatch.START_FRAMES)).isEqualTo(SpotEnd.NOT_STARTED);
    }
}
