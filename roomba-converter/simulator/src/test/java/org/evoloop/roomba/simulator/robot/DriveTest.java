package org.evoloop.roomba.simulator.robot;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.offset;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.evoloop.roomba.oi.ActuatorCommand.Drive;
import org.evoloop.roomba.oi.ActuatorCommand.DriveDirect;
import org.evoloop.roomba.oi.ActuatorCommand.DrivePwm;
import org.evoloop.roomba.oi.Command;
import org.evoloop.roomba.oi.OiMode;
import org.evoloop.roomba.oi.Packet;
import org.evoloop.roomba.oi.SensorValues;
import org.junit.jupiter.api.Test;

/** Known figures of the drive. */
class DriveTest {
    private static final Command HALT = new DriveDirect(0, 0);

    @Test
    void aSpinOf360DegreesIs1660CountsAWheel() {
        Bench bench = Bench.in(OiMode.FULL).send(new Drive(200, Drive.SPIN_COUNTERCLOCKWISE));
        double turnedDeg = 0;
        double beforeDeg = 0;
        while (turnedDeg < 360) {
            bench.ticks(1);
            turnedDeg += Math.IEEEremainder(bench.state().headingDeg() - beforeDeg, 360);
            beforeDeg = bench.state().headingDeg();
        }
        double counts = 1_660.7 * turnedDeg / 360;
        assertThat(bench.query(Packet.RIGHT_ENCODER)).isCloseTo((int) counts, within(1));
        assertThat(bench.query(Packet.LEFT_ENCODER)).isCloseTo((int) -counts, within(1));
        assertThat(bench.query(Packet.ANGLE)).isCloseTo((int) turnedDeg, within(1));
        assertThat(bench.query(Packet.DISTANCE)).isZero();
        assertThat(Math.hypot(bench.state().xMm(), bench.state().yMm())).isLessThan(1e-6);
    }

    @Test
    void aMetreIs2249Counts() {
        Bench bench = Bench.in(OiMode.FULL).send(new Drive(300, Drive.STRAIGHT));
        while (bench.state().xMm() < 1_000) {
            bench.ticks(1);
        }
        double metres = bench.state().xMm() / 1_000;
        assertThat(bench.query(Packet.LEFT_ENCODER)).isCloseTo((int) (2_249.39 * metres), within(1));
        assertThat(bench.query(Packet.RIGHT_ENCODER)).isEqualTo(bench.query(Packet.LEFT_ENCODER));
        assertThat(bench.state().yMm()).isZero();
    }

    @Test
    void theFirstSecondAt200MillimetresIs185To190() {
        double reachedMm = Bench.in(OiMode.SAFE)
                .send(new Drive(200, 32_767))
                .seconds(1)
                .state()
                .xMm();
        assertThat(reachedMm).isBetween(185.0, 190.0);
    }

    @Test
    void fullSpeedIs1125CountsASecond() {
        Bench bench = Bench.in(OiMode.FULL).send(new DriveDirect(500, 500)).seconds(3);
        int before = bench.query(Packet.LEFT_ENCODER);
        bench.seconds(3);
        assertThat(SensorValues.encoderDelta(before, bench.query(Packet.LEFT_ENCODER)))
                .isCloseTo(3_374, within(1));
    }

    @Test
    void theEncodersWrapInBothDirections() {
        for (int velocity : new int[] {500, -500}) {
            Bench bench = Bench.in(OiMode.FULL).stream(Packet.LEFT_ENCODER, Packet.RIGHT_ENCODER)
                    .send(new DriveDirect(velocity, velocity));
            List<SensorValues> frames = bench.seconds(100).frames();
            long counted = 0;
            int wraps = 0;
            for (int i = 1; i < frames.size(); i++) {
                int before = frames.get(i - 1).leftEncoderCounts();
                int after = frames.get(i).leftEncoderCounts();
                assertThat(frames.get(i).rightEncoderCounts()).isEqualTo(after);
                counted += SensorValues.encoderDelta(before, after);
                wraps += Math.abs(after - before) > 60_000 ? 1 : 0;
            }
            assertThat(wraps).isEqualTo(2);
            assertThat((double) counted / (frames.size() - 1)).isCloseTo(velocity * 0.033741, offset(0.2));
        }
    }

    @Test
    void theSignOfTheRadiusIsTheSideItTurnsTo() {
        RobotState left =
                Bench.in(OiMode.SAFE).send(new Drive(200, 500)).seconds(1).state();
        assertThat(left.headingDeg()).isPositive();
        assertThat(left.yMm()).isPositive();
        RobotState right =
                Bench.in(OiMode.SAFE).send(new Drive(200, -500)).seconds(1).state();
        assertThat(right.headingDeg()).isNegative();
        RobotState backward =
                Bench.in(OiMode.SAFE).send(new Drive(-200, 500)).seconds(1).state();
        assertThat(backward.xMm()).isNegative();
        RobotState clockwise = Bench.in(OiMode.SAFE)
                .send(new Drive(200, Drive.SPIN_CLOCKWISE))
                .seconds(0.5)
                .state();
        assertThat(clockwise.headingDeg()).isNegative();
        RobotState otherStraight = Bench.in(OiMode.SAFE)
                .send(new Drive(200, Short.MIN_VALUE))
                .seconds(1)
                .state();
        assertThat(otherStraight.headingDeg()).isZero();
        assertThat(otherStraight.xMm()).isPositive();
    }

    @Test
    void aCircleComesBackToItsStart() {
        Bench bench = Bench.in(OiMode.FULL).send(new DriveDirect(342, 171));
        bench.seconds(1);
        double radiusMm = 117.5 * (342 + 171) / (342 - 171);
        RobotState state = bench.state();
        double headingRad = Math.toRadians(state.headingDeg());
        double centerXMm = state.xMm() - radiusMm * Math.sin(headingRad);
        double centerYMm = state.yMm() + radiusMm * Math.cos(headingRad);
        for (int tick = 0; tick < 1_000; tick++) {
            state = bench.ticks(1).state();
            assertThat(Math.hypot(state.xMm() - centerXMm, state.yMm() - centerYMm))
                    .isCloseTo(radiusMm, offset(1e-6));
        }
    }

    @Test
    void speedsComeInStepsAndEverySpeedMoves() {
        for (int[] expected : new int[][] {{10, 285}, {40, 285}, {45, 570}, {200, 1_995}, {490, 4_845}, {500, 5_000}}) {
            RobotState state = Bench.in(OiMode.FULL)
                    .send(new DriveDirect(expected[0], -expected[0]))
                    .seconds(1)
                    .state();
            assertThat(state.rightMmPerS()).isCloseTo(expected[1] / 10.0, offset(1e-9));
            assertThat(state.leftMmPerS()).isCloseTo(-expected[1] / 10.0, offset(1e-9));
        }
    }

    @Test
    void wheelsTakeTheirTimeToStop() {
        Bench bench =
                Bench.in(OiMode.FULL).send(new DriveDirect(500, 500)).seconds(1).send(HALT);
        double beforeMm = bench.state().xMm();
        bench.ticks(1);
        assertThat(bench.state().leftMmPerS()).isBetween(400.0, 499.0);
        bench.seconds(1);
        assertThat(bench.state().leftMmPerS()).isZero();
        assertThat(bench.state().xMm() - beforeMm).isBetween(50.0, 100.0);
    }

    @Test
    void pulseWidthIsPartOfFullSpeed() {
        RobotState state =
                Bench.in(OiMode.FULL).send(new DrivePwm(255, -128)).seconds(1).state();
        assertThat(state.rightMmPerS()).isEqualTo(500);
        assertThat(state.leftMmPerS()).isCloseTo(-251, offset(15.0));
    }

    @Test
    void distanceAndAngleCountSinceTheLastLook() {
        Bench bench = Bench.in(OiMode.FULL).send(new DriveDirect(300, 200));
        int distanceMm = 0;
        int angleDeg = 0;
        for (int look = 0; look < 100; look++) {
            bench.ticks(look % 5);
            distanceMm += bench.query(Packet.DISTANCE);
            angleDeg += bench.query(Packet.ANGLE);
        }
        double travelledMm = (bench.query(Packet.LEFT_ENCODER) + bench.query(Packet.RIGHT_ENCODER)) / 2.0 * 0.444565;
        assertThat((double) distanceMm).as("no query loses a fraction").isCloseTo(travelledMm, offset(1.5));
        double turnedDeg =
                Math.toDegrees((bench.query(Packet.RIGHT_ENCODER) - bench.query(Packet.LEFT_ENCODER)) * 0.444565 / 235);
        assertThat((double) angleDeg).isCloseTo(turnedDeg, offset(1.5));
        assertThat(bench.query(Packet.DISTANCE)).isZero();
    }

    @Test
    void distanceSaturates() {
        Bench bench = Bench.in(OiMode.FULL).send(new DriveDirect(-500, -500)).seconds(80);
        assertThat(bench.query(Packet.DISTANCE)).isEqualTo(Short.MIN_VALUE);
        assertThat(bench.query(Packet.DISTANCE)).isZero();
    }

    @Test
    void theLastRequestsCanBeRead() {
        Bench bench = Bench.in(OiMode.FULL).send(new Drive(-200, 500), new DriveDirect(120, -30), HALT);
        bench.send(new DriveDirect(120, -30));
        assertThat(bench.query(Packet.REQUESTED_VELOCITY)).isEqualTo(-200);
        assertThat(bench.query(Packet.REQUESTED_RADIUS)).isEqualTo(500);
        assertThat(bench.query(Packet.REQUESTED_RIGHT_VELOCITY)).isEqualTo(120);
        assertThat(bench.query(Packet.REQUESTED_LEFT_VELOCITY)).isEqualTo(-30);
    }
}
