package org.evoloop.roomba.simulator.eye;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.quicktheories.QuickTheory.qt;
import static org.quicktheories.generators.SourceDSL.doubles;

import java.util.List;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.function.IntUnaryOperator;
import org.evoloop.roomba.simulator.room.Finish;
import org.evoloop.roomba.simulator.room.Marker;
import org.evoloop.roomba.simulator.room.Point;
import org.evoloop.roomba.simulator.room.Pose;
import org.evoloop.roomba.simulator.room.Room;
import org.evoloop.roomba.simulator.room.Shape;
import org.junit.jupiter.api.Test;

/** Compares pictures with the pinhole formula, calculated here independently from the options. */
class EyeGeometryTest {
    private static final EyeOptions CLEAN = Shot.with(Effects.CLEAN);
    private static final double WHITE = 0xF4;
    private static final double BLACK = 0x14;
    private static final double WRONG_BY_PX = 0.1;

    private final Eye eye = new Eye(CLEAN);

    private static double x(Point inRobotFrame) {
        return 320 - 320 / Math.tan(Math.PI / 6) * inRobotFrame.yMm() / inRobotFrame.xMm();
    }

    private static double y(Point inRobotFrame, double heightMm) {
        return 240 + 320 / Math.tan(Math.PI / 6) * (150 - heightMm) / inRobotFrame.xMm();
    }

    @Test
    void theTagsCornersAreWhereThePinholeProjectsThem() {
        // At 40 degrees a border is at least 3 pixels wide, so that edges can be distinguished.
        qt().withExamples(150)
                .forAll(
                        doubles().between(350, 3_500),
                        doubles().between(-1, 1),
                        doubles().between(-40, 40),
                        doubles().between(-180, 180))
                .checkAssert(this::checkCorners);
    }

    private void checkCorners(double distanceMm, double aside, double turnedDeg, double headingDeg) {
        Pose robot = new Pose(1_234, -567, Math.toRadians(headingDeg));
        // The largest angle at which it is still entirely in the picture.
        double mostRad = Math.toRadians(27) - Math.atan(110 / (distanceMm - 70));
        double directionRad = robot.headingRad() + aside * mostRad;
        Marker marker = Marker.at(new Pose(
                robot.xMm() + distanceMm * Math.cos(directionRad),
                robot.yMm() + distanceMm * Math.sin(directionRad),
                directionRad + Math.PI + Math.toRadians(turnedDeg)));
        Shot shot = new Shot(eye.render(Shot.PLAIN.withMarker(marker), robot, 0, 0));
        for (int side = -1; side <= 1; side += 2) {
            // The viewer's left is the marker's own right.
            Point edge = robot.seen(marker.pose().ahead(0, 75 * side));
            Point inner = robot.seen(marker.pose().ahead(0, 62.5 * side));
            double wantedX = x(edge);
            int middle = (int) Math.round(y(edge, 150));
            assertThat(edgeAt(wantedX, Math.abs(x(inner) - wantedX), column -> shot.gray(column, middle), side < 0))
                    .as("a side of the tag")
                    .isCloseTo(wantedX, within(WRONG_BY_PX));
            // The top and bottom edges in a column of the border, next to the corner.
            int column = (int) Math.floor(x(inner));
            double share =
                    (column + 0.5 - wantedX) / (x(robot.seen(marker.pose().ahead(0, -75 * side))) - wantedX);
            Point far = robot.seen(marker.pose().ahead(0, -75 * side));
            for (double heightMm : new double[] {225, 75}) {
                double wantedY = y(edge, heightMm) + share * (y(far, heightMm) - y(edge, heightMm));
                double borderPx = Math.abs(y(edge, 150) - y(edge, 162.5));
                assertThat(edgeAt(wantedY, borderPx, row -> shot.gray(column, row), heightMm > 150))
                        .as("top or bottom of the tag")
                        .isCloseTo(wantedY, within(WRONG_BY_PX));
            }
        }
    }

    /**
     * Where white becomes black, or black white, within this many pixels of a place, determined from all levels there.
     */
    private static double edgeAt(double near, double withinPx, IntUnaryOperator levels, boolean whiteFirst) {
        int from = (int) Math.floor(near - withinPx);
        int to = (int) Math.ceil(near + withinPx);
        double white = 0;
        for (int at = from; at < to; at++) {
            white += (levels.applyAsInt(at) - BLACK) / (WHITE - BLACK);
        }
        return whiteFirst ? from + white : to - white;
    }

    @Test
    void theTagIsTheOneOfItsIdAndUpright() {
        for (int id = 0; id <= Marker.HIGHEST_ID; id++) {
            Room room = Shot.PLAIN.withMarker(new Marker(new Pose(600, 0, Math.PI), id, 150, 150, false, false));
            Shot shot = new Shot(eye.render(room, Pose.ORIGIN, 0, 0));
            for (int row = 0; row < 4; row++) {
                for (int column = 0; column < 4; column++) {
                    Point cell = new Point(600, 75 - 25 * (column + 1.5));
                    double heightMm = 225 - 25 * (row + 1.5);
                    assertThat(shot.gray((int) x(cell), (int) y(cell, heightMm)) > 128)
                            .as("id %d, row %d, column %d", id, row, column)
                            .isEqualTo(TagCode.isWhite(id, row, column));
                }
            }
        }
    }

    @Test
    void theDictionaryHasItsKnownDistance() {
        int[] codes = new int[Marker.HIGHEST_ID + 1];
        for (int id = 0; id < codes.length; id++) {
            for (int cell = 0; cell < 16; cell++) {
                codes[id] = (codes[id] << 1) | (TagCode.isWhite(id, cell / 4, cell % 4) ? 1 : 0);
            }
        }
        assertThat(codes[0]).isEqualTo(0xB532);
        for (int one = 0; one < codes.length; one++) {
            for (int other = 0; other < one; other++) {
                int turned = codes[other];
                for (int turns = 0; turns < 4; turns++) {
                    assertThat(Integer.bitCount(codes[one] ^ turned))
                            .as("ids %d and %d, turned %d times", one, other, turns)
                            .isGreaterThanOrEqualTo(4);
                    turned = turned(turned);
                }
            }
        }
    }

    private static int turned(int code) {
        int turned = 0;
        for (int cell = 0; cell < 16; cell++) {
            turned = (turned << 1) | ((code >> (15 - ((3 - cell % 4) * 4 + cell / 4))) & 1);
        }
        return turned;
    }

    @Test
    void whatIsBehindFurnitureIsHiddenAndWhatIsBesideOrAboveIsNot() {
        Finish blue = new Finish(OptionalInt.of(0x2040C0), OptionalDouble.of(400));
        Room room = Room.of(
                List.of(
                        Shot.box(Shape.Kind.WALL, -3_000, -2_000, 3_000, 2_000, Finish.ANY),
                        Shot.box(Shape.Kind.OBSTACLE, 1_000, -300, 1_300, 300, blue)),
                null,
                Pose.ORIGIN);
        Shot bare = new Shot(eye.render(room, Pose.ORIGIN, 0, 0));
        Shot hidden = new Shot(eye.render(room.withMarker(Marker.at(new Pose(2_000, 0, Math.PI))), Pose.ORIGIN, 0, 0));
        assertThat(hidden.isLike(bare)).isTrue();
        Marker high = new Marker(new Pose(2_000, 0, Math.PI), 0, 150, 900, false, false);
        assertThat(new Shot(eye.render(room.withMarker(high), Pose.ORIGIN, 0, 0)).isLike(bare))
                .isFalse();
        Marker before = Marker.at(new Pose(900, 0, Math.PI));
        Shot seen = new Shot(eye.render(room.withMarker(before), Pose.ORIGIN, 0, 0));
        assertThat(seen.isLike(bare)).isFalse();
    }

    @Test
    void aMarkerOnAWallIsInFrontOfIt() {
        Room room = Room.of(
                List.of(Shot.box(Shape.Kind.WALL, -2_000, -2_000, 2_000, 2_000, Finish.ANY)), null, Pose.ORIGIN);
        Marker marker = Marker.at(new Pose(2_000, 0, Math.PI));
        Shot shot = new Shot(eye.render(room.withMarker(marker), Pose.ORIGIN, 0, 0));
        Point quiet = new Point(2_000, 85);
        assertThat((double) shot.gray((int) x(quiet), (int) y(quiet, 150))).isEqualTo(WHITE);
    }

    @Test
    void fromBehindOrUnderAClothThereIsNoTag() {
        Pose place = new Pose(600, 0, Math.PI);
        Shot front = new Shot(eye.render(Shot.PLAIN.withMarker(Marker.at(place)), Pose.ORIGIN, 0, 0));
        Shot back = new Shot(eye.render(Shot.PLAIN.withMarker(Marker.at(new Pose(600, 0, 0))), Pose.ORIGIN, 0, 0));
        Shot covered =
                new Shot(eye.render(Shot.PLAIN.withMarker(Marker.at(place).covered(true)), Pose.ORIGIN, 0, 0));
        Point border = new Point(600, 70);
        int x = (int) x(border);
        assertThat((double) front.gray(x, 240)).isEqualTo(BLACK);
        for (Shot shot : List.of(back, covered)) {
            assertThat(shot.gray(x, 240)).isEqualTo(shot.gray(330, 250)).isNotEqualTo((int) BLACK);
        }
    }

    @Test
    void whereThereIsACliffThereIsNoFloor() {
        Room whole = Room.of(
                List.of(Shot.box(Shape.Kind.WALL, -3_000, -2_000, 3_000, 2_000, Finish.ANY)), null, Pose.ORIGIN);
        Room room = Room.of(
                List.of(whole.shapes().get(0), Shot.box(Shape.Kind.CLIFF, 800, -200, 1_000, 200, Finish.ANY)),
                null,
                Pose.ORIGIN);
        Shot shot = new Shot(eye.render(room, Pose.ORIGIN, 0, 0));
        Shot floor = new Shot(eye.render(whole, Pose.ORIGIN, 0, 0));
        Point within = new Point(900, 100);
        assertThat(shot.rgb((int) x(within), (int) y(within, 0))).isEqualTo(0x1A1815);
        Point beyond = new Point(1_100, 100);
        assertThat(shot.rgb((int) x(beyond), (int) y(beyond, 0)))
                .isEqualTo(floor.rgb((int) x(beyond), (int) y(beyond, 0)));
    }

    @Test
    void aLineOfSightAlongAWallOrThroughItIsNoFailure() {
        Room room = Room.of(
                List.of(
                        Shot.box(Shape.Kind.WALL, -2_000, -2_000, 2_000, 2_000, Finish.ANY),
                        Shot.box(Shape.Kind.OBSTACLE, 500, 500, 900, 900, Finish.ANY)),
                new Pose(-1_800, 0, Math.PI),
                Pose.ORIGIN);
        Room withMarker = room.withMarker(Marker.at(new Pose(500, 300, Math.PI)));
        Eye small = new Eye(CLEAN.withSize(160, 120));
        for (double xMm = -2_500; xMm <= 2_500; xMm += 500) {
            for (double yMm = -2_500; yMm <= 2_500; yMm += 500) {
                for (int eighth = 0; eighth < 8; eighth++) {
                    Pose pose = new Pose(xMm, yMm, eighth * Math.PI / 4);
                    Shot shot = new Shot(small.render(withMarker, pose, 0, 0));
                    for (int x = 0; x < 160; x += 7) {
                        assertThat(shot.gray(x, 100))
                                .as("%s, column %d", pose, x)
                                .isBetween(4, 250);
                    }
                }
            }
        }
    }
}
