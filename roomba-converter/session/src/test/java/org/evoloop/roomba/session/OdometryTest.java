package org.evoloop.roomba.session;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.evoloop.roomba.session.Frames.encoders;
import static org.quicktheories.QuickTheory.qt;
import static org.quicktheories.generators.SourceDSL.integers;
import static org.quicktheories.generators.SourceDSL.lists;

import java.util.List;
import org.evoloop.roomba.oi.SensorValues;
import org.junit.jupiter.api.Test;

class OdometryTest {
    private static final double COUNTS_A_REVOLUTION = 508.8;
    private static final double MM_A_REVOLUTION = Math.PI * 72;

    private final Odometry odometry = new Odometry();
    private int left;
    private int right;

    /** Turns the wheels by this many counts. */
    private OdometryPose roll(int leftCounts, int rightCounts) {
        left += leftCounts;
        right += rightCounts;
        return odometry.update(encoders(left, right));
    }

    private static void assertPose(OdometryPose pose, double xMm, double yMm, double headingRad) {
        assertThat(pose.xMm()).isCloseTo(xMm, within(0.001));
        assertThat(pose.yMm()).isCloseTo(yMm, within(0.001));
        assertThat(pose.headingRad()).isCloseTo(headingRad, within(0.00001));
    }

    @Test
    void theFirstReadingIsTheOrigin() {
        assertThat(odometry.update(encoders(12_345, -321))).isEqualTo(OdometryPose.ORIGIN);
    }

    @Test
    void fiveRevolutionsOfBothWheelsGoStraightAhead() {
        roll(0, 0);
        assertPose(roll(2_544, 2_544), 5 * MM_A_REVOLUTION, 0, 0);
        assertPose(roll(-2_544, -2_544), 0, 0, 0);
    }

    @Test
    void anArcIsExactHoweverFewReadingsItHas() {
        roll(0, 0);
        int counts = 1_000;
        double turned = counts * MM_A_REVOLUTION / COUNTS_A_REVOLUTION / 235;
        double radius = 235 / 2.0;
        OdometryPose inOne = roll(0, counts);
        assertPose(inOne, radius * Math.sin(turned), radius * (1 - Math.cos(turned)), turned);

        Odometry inMany = new Odometry();
        OdometryPose pose = OdometryPose.ORIGIN;
        for (int i = 0; i <= counts; i++) {
            pose = inMany.update(encoders(0, i));
        }
        assertPose(pose, inOne.xMm(), inOne.yMm(), inOne.headingRad());
    }

    @Test
    void oppositeWheelsTurnOnTheSpotToTheLeft() {
        roll(0, 0);
        OdometryPose pose = roll(-415, 415);
        assertPose(pose, 0, 0, 2 * 415 * Odometry.MM_PER_COUNT / 235);
        assertThat(pose.headingRad()).isCloseTo(Math.PI / 2, within(0.005));
    }

    @Test
    void theWrapOfTheEncodersIsNoJourneyForwardsNorBackwards() {
        left = 32_700;
        right = 32_700;
        roll(0, 0);
        assertPose(roll(100, 100), 100 * Odometry.MM_PER_COUNT, 0, 0);
        assertPose(roll(-100, -100), 0, 0, 0);
        assertPose(roll(65_536, 65_536), 0, 0, 0);
    }

    @Test
    void whateverWayIsDrivenBackwardsAgainEndsWhereItBegan() {
        qt().forAll(lists().of(integers().between(-2_000, 2_000)).ofSizeBetween(2, 60))
                .checkAssert(counts -> {
                    Odometry there = new Odometry();
                    int[] at = {0, 0};
                    there.update(encoders(0, 0));
                    OdometryPose last = OdometryPose.ORIGIN;
                    for (int i = 0; i + 1 < counts.size(); i += 2) {
                        last = there.update(step(at, counts, i, 1));
                    }
                    for (int i = counts.size() / 2 * 2 - 2; i >= 0; i -= 2) {
                        last = there.update(step(at, counts, i, -1));
                    }
                    assertPose(last, 0, 0, 0);
                });
    }

    private static SensorValues step(int[] at, List<Integer> counts, int i, int direction) {
        at[0] += direction * counts.get(i);
        at[1] += direction * counts.get(i + 1);
        return encoders(at[0], at[1]);
    }

    @Test
    void aClosedCircleComesBack() {
        qt().forAll(integers().between(0, 40), integers().between(1, 40)).checkAssert((inner, more) -> {
            Odometry round = new Odometry();
            double turnAStep = more * Odometry.MM_PER_COUNT / Odometry.WHEEL_BASE_MM;
            long steps = Math.round(2 * Math.PI / turnAStep);
            OdometryPose pose = OdometryPose.ORIGIN;
            for (int i = 0; i <= steps; i++) {
                pose = round.update(encoders(i * inner, i * (inner + more)));
            }
            double stepMm = (inner + more / 2.0) * Odometry.MM_PER_COUNT;
            assertThat(pose.distanceTo(0, 0)).isLessThanOrEqualTo(stepMm);
            assertThat(pose.headingRad()).isCloseTo(2 * Math.PI, within(turnAStep));
        });
    }

    @Test
    void aPoseGivesDistanceAndBearing() {
        OdometryPose pose = new OdometryPose(100, 200, 7 * Math.PI / 2);
        assertThat(pose.distanceTo(400, 600)).isCloseTo(500, within(0.001));
        assertThat(pose.bearingTo(100, 0)).isCloseTo(0, within(0.001));
        assertThat(pose.bearingTo(200, 200)).isCloseTo(Math.PI / 2, within(0.001));
        assertThat(pose.bearingTo(0, 200)).isCloseTo(-Math.PI / 2, within(0.001));
    }
}
