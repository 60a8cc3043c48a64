package org.evoloop.roomba.simulator.room;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.offset;
import static org.quicktheories.QuickTheory.qt;
import static org.quicktheories.generators.SourceDSL.doubles;

import org.junit.jupiter.api.Test;

class PoseTest {

    @Test
    void oneArcIsAsGoodAsManyShortSteps() {
        qt().forAll(
                        doubles().between(-100, 100),
                        doubles().between(-100, 100),
                        doubles().between(-4, 4))
                .checkAssert((leftMm, rightMm, headingRad) -> {
                    Pose start = new Pose(30, -20, headingRad);
                    Pose inOne = start.rolled(leftMm, rightMm);
                    double xMm = start.xMm();
                    double yMm = start.yMm();
                    int steps = 1_000;
                    double turnRad = (rightMm - leftMm) / Pose.WHEEL_BASE_MM;
                    for (int step = 0; step < steps; step++) {
                        double midwayRad = headingRad + turnRad * (step + 0.5) / steps;
                        xMm += (leftMm + rightMm) / 2 / steps * Math.cos(midwayRad);
                        yMm += (leftMm + rightMm) / 2 / steps * Math.sin(midwayRad);
                    }
                    assertThat(inOne.xMm()).isCloseTo(xMm, offset(1e-3));
                    assertThat(inOne.yMm()).isCloseTo(yMm, offset(1e-3));
                    assertThat(Math.IEEEremainder(inOne.headingRad() - headingRad - turnRad, 2 * Math.PI))
                            .isCloseTo(0, offset(1e-9));
                });
    }

    @Test
    void rollingBackLeadsBack() {
        qt().forAll(
                        doubles().between(-500, 500),
                        doubles().between(-500, 500),
                        doubles().between(-4, 4))
                .checkAssert((leftMm, rightMm, headingRad) -> {
                    Pose start = new Pose(1, 2, headingRad);
                    Pose back = start.rolled(leftMm, rightMm).rolled(-leftMm, -rightMm);
                    assertThat(start.distanceMmTo(back.xMm(), back.yMm())).isLessThan(1e-3);
                });
    }

    @Test
    void theHeadingStaysWithinHalfATurn() {
        qt().forAll(doubles().between(-100, 100))
                .checkAssert(headingRad ->
                        assertThat(new Pose(0, 0, headingRad).headingDeg()).isBetween(-180.0, 180.0));
    }

    @Test
    void theBearingIsTheTurnToAPoint() {
        Pose pose = new Pose(100, 100, Math.PI / 2);
        assertThat(Math.toDegrees(pose.bearingRadTo(100, 300))).isCloseTo(0, offset(1e-9));
        assertThat(Math.toDegrees(pose.bearingRadTo(50, 100))).isCloseTo(90, offset(1e-9));
        assertThat(Math.toDegrees(pose.bearingRadTo(150, 100))).isCloseTo(-90, offset(1e-9));
    }
}
