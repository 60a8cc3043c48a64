package org.evoloop.roomba.session.inference;

import static org.assertj.core.api.Assertions.assertThat;

import org.evoloop.roomba.oi.Command;
import org.evoloop.roomba.oi.OiMode;
import org.evoloop.roomba.oi.Packet;
import org.evoloop.roomba.oi.SensorValues;
import org.evoloop.roomba.session.Frames;
import org.evoloop.roomba.session.inference.ActivityEstimate.EstimatedActivity;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** The activity inferred from the robot's commands and motors. */
class ActivityEstimateTest {
    private static final SensorValues DRIVING = Frames.resting(OiMode.PASSIVE).with(Packet.CURRENT, -900);

    private final ActivityEstimate estimate = new ActivityEstimate();
    private long nowNanos;

    @BeforeEach
    void switchOn() {
        estimate.commanded(new Command.Safe());
    }

    private boolean frames(int count, SensorValues values) {
        boolean reported = false;
        for (int frame = 0; frame < count; frame++) {
            nowNanos += Frames.APART_NANOS;
            reported |= estimate.update(values, false, true, nowNanos);
        }
        return reported;
    }

    @Test
    void eachCommandBeginsItsWorkAndPausesAnother() {
        estimate.commanded(new Command.SeekDock());
        assertThat(estimate.activity()).isEqualTo(EstimatedActivity.DOCK);
        estimate.commanded(new Command.Max());
        assertThat(estimate.activity()).isEqualTo(EstimatedActivity.ON);
        estimate.commanded(new Command.Max());
        assertThat(estimate.activity()).isEqualTo(EstimatedActivity.MAX);
        estimate.commanded(new Command.Power());
        assertThat(estimate.activity()).isEqualTo(EstimatedActivity.STANDBY);
    }

    @Test
    void framesThatLagBehindAPauseAreNoNewWork() {
        estimate.commanded(new Command.Clean());
        frames(30, Frames.cleaning());
        estimate.commanded(new Command.Clean());

        assertThat(frames(10, Frames.cleaning())).isFalse();
        frames(100, Frames.resting(OiMode.PASSIVE));

        assertThat(estimate.activity()).isEqualTo(EstimatedActivity.ON);
    }

    @Test
    void oldFramesThatComeAtOnceDoNotMeanThatItsWorkNeverBegan() {
        estimate.commanded(new Command.Clean());
        for (int frame = 0; frame < 2 * ActivityEstimate.START_FRAMES; frame++) {
            assertThat(estimate.update(Frames.resting(OiMode.PASSIVE), false, true, nowNanos))
                    .isFalse();
        }
        assertThat(estimate.activity()).isEqualTo(EstimatedActivity.CLEAN);
    }

    @Test
    void aPauseThatGotLostShowsInTheMotors() {
        estimate.commanded(new Command.Clean());
        frames(100, Frames.cleaning());
        estimate.commanded(new Command.Clean());

        assertThat(frames(CommandEffect.SHOW_FRAMES + ActivityEstimate.WORK_FRAMES, Frames.cleaning()))
                .isTrue();

        assertThat(estimate.activity()).isEqualTo(EstimatedActivity.CLEAN);
    }

    @Test
    void brushesThatRestWhileItDrivesMeanThatItGoesHome() {
        estimate.commanded(new Command.Clean());
        frames(500, Frames.cleaning());
        assertThat(frames(ActivityEstimate.HOMEWARD_FRAMES - 1, DRIVING)).isFalse();
        assertThat(frames(1, DRIVING)).isTrue();
        assertThat(estimate.activity()).isEqualTo(EstimatedActivity.DOCK);
    }

    @Test
    void aRobotWithoutBrushesOnlyCleans() {
        estimate.commanded(new Command.Clean());
        frames(3 * ActivityEstimate.HOMEWARD_FRAMES, DRIVING);
        assertThat(estimate.activity()).isEqualTo(EstimatedActivity.CLEAN);
    }
}
