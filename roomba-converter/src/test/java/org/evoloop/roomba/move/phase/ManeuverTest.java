package org.evoloop.roomba.move.phase;

import static org.assertj.core.api.Assertions.assertThat;
import static org.quicktheories.QuickTheory.qt;
import static org.quicktheories.generators.SourceDSL.doubles;

import org.evoloop.roomba.oi.ActuatorCommand.DriveDirect;
import org.junit.jupiter.api.Test;

class ManeuverTest {
    private static DriveDirect wheels(Maneuver maneuver) {
        assertThat(maneuver).isInstanceOf(Maneuver.Drive.class);
        return ((Maneuver.Drive) maneuver).wheels();
    }

    private static DriveDirect towards(double remainingMm, double bearingDeg) {
        return wheels(Maneuver.towards(remainingMm, Math.toRadians(bearingDeg)));
    }

    @Test
    void straightAheadBothWheelsTurnAlikeAndSlowerNearby() {
        assertThat(towards(2_000, 0)).isEqualTo(new DriveDirect(85, 85));
        assertThat(towards(100, 0)).isEqualTo(new DriveDirect(50, 50));
        assertThat(towards(10, 0)).isEqualTo(new DriveDirect(40, 40));
    }

    @Test
    void aGoalToTheLeftMakesTheRightWheelFaster() {
        assertThat(towards(1_000, 10)).isEqualTo(new DriveDirect(126, 44));
        assertThat(towards(1_000, -10)).isEqualTo(new DriveDirect(44, 126));
    }

    @Test
    void aTurnOnTheSpotIsCounterclockwiseIfPositiveAndSlowsDownInTheEnd() {
        assertThat(wheels(Maneuver.turn(Math.toRadians(90)))).isEqualTo(new DriveDirect(150, -150));
        assertThat(wheels(Maneuver.turn(Math.toRadians(-8)))).isEqualTo(new DriveDirect(-80, 80));
        assertThat(wheels(Maneuver.turn(Math.toRadians(1)))).isEqualTo(new DriveDirect(40, -40));
    }

    @Test
    void straightOnIsBackwardsIfNegative() {
        assertThat(wheels(Maneuver.straight(500))).isEqualTo(new DriveDirect(85, 85));
        assertThat(wheels(Maneuver.straight(-10))).isEqualTo(new DriveDirect(-40, -40));
    }

    @Test
    void whateverDistanceIsLeftTheRobotNeverDrivesFastAndTurnsTheRightWay() {
        qt().forAll(doubles().between(0, 1e6), doubles().between(-20, 20)).checkAssert((remainingMm, bearingDeg) -> {
            DriveDirect wheels = towards(remainingMm, bearingDeg);
            assertThat((wheels.rightMmPerS() + wheels.leftMmPerS()) / 2.0).isBetween(39.0, 86.0);
            int turning = wheels.rightMmPerS() - wheels.leftMmPerS();
            assertThat(turning * Math.signum(bearingDeg)).isGreaterThanOrEqualTo(0);
        });
    }
}
