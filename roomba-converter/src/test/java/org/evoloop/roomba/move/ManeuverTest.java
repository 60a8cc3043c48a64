package org.evoloop.roomba.move;

import static org.assertj.core.api.Assertions.assertThat;
import static org.quicktheories.QuickTheory.qt;
import static org.quicktheories.generators.SourceDSL.doubles;

import org.evoloop.roomba.move.StartPointSensor.Sighting;
import org.evoloop.roomba.oi.ActuatorCommand.DriveDirect;
import org.junit.jupiter.api.Test;

class ManeuverTest {
    private static DriveDirect wheels(double distanceMm, double bearingDeg) {
        Maneuver maneuver = Maneuver.on(Course.to(new Sighting(distanceMm, Math.toRadians(bearingDeg))));
        assertThat(maneuver).isInstanceOf(Maneuver.Drive.class);
        return ((Maneuver.Drive) maneuver).wheels();
    }

    @Test
    void theCourseDependsOnDistanceFirstAndThenOnTheSide() {
        assertThat(Course.to(new Sighting(19.9, Math.PI))).isInstanceOf(Course.Arrived.class);
        assertThat(Course.to(new Sighting(20, 0))).isInstanceOf(Course.Approach.class);
        assertThat(Course.to(new Sighting(500, Math.toRadians(19.9)))).isInstanceOf(Course.Approach.class);
        assertThat(Course.to(new Sighting(500, Math.toRadians(-20.1)))).isInstanceOf(Course.Turn.class);
    }

    @Test
    void straightAheadBothWheelsTurnAlikeFastFarAwayAndSlowNearby() {
        assertThat(wheels(2_000, 0)).isEqualTo(new DriveDirect(300, 300));
        assertThat(wheels(100, 0)).isEqualTo(new DriveDirect(150, 150));
        assertThat(wheels(21, 0)).isEqualTo(new DriveDirect(40, 40));
    }

    @Test
    void aPointToTheLeftMakesTheRightWheelFaster() {
        assertThat(wheels(1_000, 10)).isEqualTo(new DriveDirect(341, 259));
        assertThat(wheels(1_000, -10)).isEqualTo(new DriveDirect(259, 341));
    }

    @Test
    void aPointToTheSideIsTurnedToOnTheSpot() {
        assertThat(wheels(1_000, 90)).isEqualTo(new DriveDirect(236, -236));
        assertThat(wheels(1_000, -90)).isEqualTo(new DriveDirect(-236, 236));
        assertThat(wheels(1_000, 180)).isEqualTo(new DriveDirect(300, -300));
        assertThat(wheels(30, 21)).isEqualTo(new DriveDirect(55, -55));
    }

    @Test
    void withoutSightTheRobotStandsAndWithoutControlItGivesUp() {
        assertThat(Maneuver.on(new Course.Lost())).isEqualTo(new Maneuver.Drive(new DriveDirect(0, 0)));
        assertThat(Maneuver.on(new Course.Arrived())).isEqualTo(new Maneuver.Arrive());
        assertThat(Maneuver.on(new Course.OutOfControl())).isInstanceOf(Maneuver.GiveUp.class);
    }

    @Test
    void whateverIsSeenTheWheelsStayWithinTheirLimitsAndTurnTheRightWay() {
        qt().forAll(doubles().between(20, 1e6), doubles().between(-180, 180)).checkAssert((distanceMm, bearingDeg) -> {
            DriveDirect wheels = wheels(distanceMm, bearingDeg);
            assertThat(wheels.rightMmPerS()).isBetween(-500, 500);
            assertThat(wheels.leftMmPerS()).isBetween(-500, 500);
            int turning = wheels.rightMmPerS() - wheels.leftMmPerS();
            assertThat(turning * Math.signum(bearingDeg)).isGreaterThanOrEqualTo(0);
        });
    }
}
