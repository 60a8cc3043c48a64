package org.evoloop.roomba.simulator.room;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.offset;
import static org.quicktheories.QuickTheory.qt;
import static org.quicktheories.generators.SourceDSL.doubles;

import java.util.List;
import org.junit.jupiter.api.Test;

class RoomTest {
    private static final Room SQUARE = RoomFile.parse("square", List.of("wall 0 0 2000 2000", "start 1000 1000 0"));
    private static final Room CORNER = RoomFile.parse(
            "corner",
            List.of(
                    "wall 0 0  3000 0  3000 3000  0 3000",
                    "obstacle 1500 1500  3000 1600  1400 2900",
                    "cliff 0 2500 500 3000",
                    "start 400 400 0"));

    @Test
    void noMoveEndsInAWall() {
        qt().forAll(
                        doubles().between(170, 2_830),
                        doubles().between(170, 2_830),
                        doubles().between(-Math.PI, Math.PI),
                        doubles().between(-8, 8))
                .assuming((xMm, yMm, headingRad, stepMm) -> CORNER.isFree(new Pose(xMm, yMm, headingRad)))
                .checkAssert((xMm, yMm, headingRad, stepMm) -> {
                    Pose from = new Pose(xMm, yMm, headingRad);
                    Pose moved = CORNER.moved(from, from.at(from.ahead(stepMm, 0)));
                    assertThat(CORNER.touched(moved, -0.001)).isEmpty();
                    assertThat(from.distanceMmTo(moved.center())).isLessThanOrEqualTo(3 * Math.abs(stepMm) + 1e-3);
                    assertThat(moved.headingRad()).isEqualTo(from.headingRad());
                });
    }

    @Test
    void nothingInTheWayNothingChanges() {
        Pose from = new Pose(1_000, 1_000, 1);
        Pose wanted = from.rolled(5, 6);
        assertThat(SQUARE.moved(from, wanted)).isEqualTo(wanted);
    }

    @Test
    void theWayAheadEndsAtTheNextWall() {
        Pose pose = new Pose(500, 1_000, 0);
        assertThat(SQUARE.freeMm(pose, 0)).isCloseTo(1_500, offset(1e-6));
        assertThat(SQUARE.freeMm(pose, Math.PI)).isCloseTo(500, offset(1e-6));
        assertThat(SQUARE.freeMm(pose, Math.PI / 4)).isCloseTo(1_000 * Math.sqrt(2), offset(1e-6));
        assertThat(Room.OPEN.freeMm(pose, 0)).isInfinite();
    }

    @Test
    void aRobotFindsNoRoomInWallsObstaclesAndBetween() {
        assertThat(CORNER.isFree(new Pose(400, 400, 0))).isTrue();
        assertThat(CORNER.isFree(new Pose(169, 400, 0))).isFalse();
        assertThat(CORNER.isFree(new Pose(1_900, 2_000, 0)))
                .as("within the obstacle")
                .isFalse();
    }

    @Test
    void aPolygonIsWhatIsWithinItsSides() {
        Shape arrow = new Shape(
                Shape.Kind.CLIFF, List.of(new Point(0, 0), new Point(100, 50), new Point(0, 100), new Point(40, 50)));
        assertThat(arrow.contains(new Point(60, 50))).isTrue();
        assertThat(arrow.contains(new Point(20, 50))).as("in the notch").isFalse();
        assertThat(arrow.contains(new Point(20, 20))).isTrue();
        assertThat(arrow.contains(new Point(-1, 50))).isFalse();
        assertThat(arrow.contains(new Point(101, 50))).isFalse();
    }

    @Test
    void theDockIsSeenFromItsFrontWhereNothingIsBetween() {
        Room room =
                RoomFile.parse("room", List.of("dock 300 1000 180", "obstacle 1500 900 1600 1100", "start 900 1000 0"));
        assertThat(room.seesDock(new Pose(1_000, 1_000, 2))).isTrue();
        assertThat(room.seesDock(new Pose(1_000, 1_500, 0))).isTrue();
        assertThat(room.seesDock(new Pose(2_500, 1_000, 0)))
                .as("behind the obstacle")
                .isFalse();
        assertThat(room.seesDock(new Pose(400, 2_500, 0))).as("far to its side").isFalse();
        assertThat(room.seesDock(new Pose(-500, 1_000, 0))).as("behind it").isFalse();
        assertThat(Room.OPEN.seesDock(Pose.ORIGIN)).isFalse();
    }

    @Test
    void aStartInAWallIsRefused() {
        assertThatThrownBy(() -> Room.of(SQUARE.shapes(), null, Pose.ORIGIN))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage(
                        "the robot cannot start at (0, 0) mm, 0 degrees: something solid or a cliff is within 170 mm");
    }
}
