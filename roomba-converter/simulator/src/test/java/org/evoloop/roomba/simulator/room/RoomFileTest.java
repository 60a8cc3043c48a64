package org.evoloop.roomba.simulator.room;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class RoomFileTest {

    @Test
    void everyKindOfLineIsUnderstood(@TempDir Path folder) throws IOException {
        Path file = Files.writeString(folder.resolve("room.txt"), """
                # A room

                wall     0 0  4000 3000   # all around
                obstacle 1000 1000  1500 1000  1200.5 1400
                  cliff    3000 2000  3500 2500
                dock     270 1500 180
                start    700 700 -90
                """);
        Room room = RoomFile.read(file);
        assertThat(room.shapes())
                .extracting(Shape::kind)
                .containsExactly(Shape.Kind.WALL, Shape.Kind.OBSTACLE, Shape.Kind.CLIFF);
        assertThat(room.shapes().get(0).corners())
                .containsExactly(new Point(0, 0), new Point(4_000, 0), new Point(4_000, 3_000), new Point(0, 3_000));
        assertThat(room.shapes().get(1).corners()).contains(new Point(1_200.5, 1_400));
        assertThat(room.dock()).contains(new Pose(270, 1_500, Math.PI));
        assertThat(room.start()).isEqualTo(new Pose(700, 700, -Math.PI / 2));
        assertThat(room.isCliff(new Point(3_100, 2_100))).isTrue();
        assertThat(room.isCliff(new Point(2_900, 2_100))).isFalse();
    }

    @Test
    void looksAndMarkersAreUnderstood() {
        Room room = RoomFile.parse(
                "a",
                List.of(
                        "wall -2000 -2000 2000 2000 height 2400",
                        "obstacle 500 500 900 900 900 600 color C92a2a height 800",
                        "marker 1400 500 180 7 200 160.5 # the starting point"));
        assertThat(room.shapes())
                .extracting(Shape::finish)
                .containsExactly(
                        new Finish(OptionalInt.empty(), OptionalDouble.of(2_400)),
                        new Finish(OptionalInt.of(0xC92A2A), OptionalDouble.of(800)));
        assertThat(room.marker()).contains(new Marker(new Pose(1_400, 500, Math.PI), 7, 200, 160.5, false, false));
        assertThat(room.withDock(Pose.ORIGIN).marker())
                .as("in a room that changes")
                .isPresent();
        assertThat(RoomFile.parse("a", List.of("marker 1 2 90")).marker())
                .contains(Marker.at(new Pose(1, 2, Math.PI / 2)));
    }

    @Test
    void theLivingRoomHidesItsMarkerBehindTheRobot() {
        Room room = RoomFile.livingRoom();
        Marker marker = room.marker().orElseThrow();
        Pose goal = marker.before(RandomRooms.GOAL_MM);
        assertThat(goal.distanceMmTo(1_000, 500)).isLessThan(1);
        assertThat(room.isFree(goal)).isTrue();
        assertThat(room.touched(goal, 480)).as("space for a spot").isEmpty();
        Point place = marker.pose().center();
        assertThat(Math.abs(room.start().bearingRadTo(place.xMm(), place.yMm())))
                .isGreaterThan(Math.PI / 2);
        assertThat(room.dock()).isPresent();
    }

    @Test
    void theMarkerIsNoObstacle() {
        Room room = RoomFile.parse("a", List.of("marker 0 0 180"));
        assertThat(room.isFree(Pose.ORIGIN)).isTrue();
        assertThat(room.touched(Pose.ORIGIN, 100)).isEmpty();
    }

    @Test
    void aSolidMarkerIsInTheWay() {
        Room room = RoomFile.parse("a", List.of("start -1000 0 0", "marker 0 0 180 solid"));
        assertThat(room.isFree(new Pose(-169, 0, 0))).isFalse();
        assertThat(room.isFree(new Pose(-171, 0, 0))).isTrue();
        assertThat(room.isFree(new Pose(0, 271, 0))).as("beside the board").isTrue();
        assertThat(room.moved(new Pose(-171, 0, 0), new Pose(-160, 0, 0)).xMm()).isLessThan(-169);
        Marker moved = room.marker().orElseThrow().movedTo(new Pose(-1000, 0, 0));
        assertThat(room.withMarker(moved.covered(true)).isFree(Pose.ORIGIN)).isTrue();
        assertThat(room.withMarker(moved.covered(true)).isFree(new Pose(-1000, 0, 0)))
                .isFalse();
        assertThat(RoomFile.parse("a", List.of("marker 500 0 0 7 200 160 solid"))
                        .marker())
                .contains(new Marker(new Pose(500, 0, 0), 7, 200, 160, false, true));
    }

    @Test
    void aSolidMarkerWhereTheRobotBeginsIsRefused() {
        assertThatThrownBy(() -> RoomFile.parse("my.room", List.of("marker 100 0 180 solid")))
                .hasMessageStartingWith("my.room: the robot cannot start at (0, 0) mm");
    }

    @Test
    void withoutAStartItBeginsOnTheDockOrAtTheOrigin() {
        assertThat(RoomFile.parse("a", List.of()).start()).isEqualTo(Pose.ORIGIN);
        assertThat(RoomFile.parse("a", List.of("dock 100 200 90")).start()).isEqualTo(new Pose(100, 200, Math.PI / 2));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "sofa 1 2 3 4    | 'sofa' is unknown; a line begins with wall, obstacle, cliff, dock, start or marker",
                "wall 1 2 3      | wall has 3 numbers; it needs two corners (a rectangle) or more (a polygon), each as X Y",
                "cliff           | cliff has 0 numbers; it needs two corners (a rectangle) or more (a polygon), each as X Y",
                "wall 1 2 3 four | 'four' is not a number",
                "wall 1 2 3 1e6  | '1e6' is too far away; allowed is -100000 to 100000",
                "wall 1 2 3 NaN  | 'NaN' is too far away; allowed is -100000 to 100000",
                "dock 1 2        | dock has 2 numbers; it needs three: X Y HEADING",
                "start 1 2 3     | there is a start already; remove one of the two",
                "marker 1 2      | marker has 2 numbers; it needs three: X Y HEADING, and takes up to three more: ID SIDE HEIGHT, then 'solid'",
                "marker solid   | marker has 0 numbers; it needs three: X Y HEADING, and takes up to three more: ID SIDE HEIGHT, then 'solid'",
                "marker 1 2 3 firm | 'firm' is not a number",
                "marker 1 2 3 50 | the marker's id is 50; allowed is 0 to 49",
                "marker 1 2 3 .5 | the marker's id is 0.5; it is a whole number",
                "marker 1 2 3 0 5 | the marker's side is 5.0 mm; allowed is 20 to 1000",
                "marker 1 2 3 0 150 90 | the marker's middle is 90.0 mm high; allowed is 100 to 2000",
                "wall 1 2 3 4 color red | color is 'red'; it takes six hexadecimal digits, for example 1971c2",
                "wall 1 2 3 4 color | color is ''; it takes six hexadecimal digits, for example 1971c2",
                "wall 1 2 3 4 height 100 | the height is 100.0 mm; allowed is 200 to 5000",
                "wall 1 2 3 4 height | '' is not a number",
                "wall 1 2 3 4 height 300 red | 'red' is unknown here; after the corners come 'color RRGGBB' and 'height MM'",
                "cliff 1 2 3 4 color 112233 | 'color' is not a number",
            })
    void aMistakeNamesFileLineAndRemedy(String line, String message) {
        assertThatThrownBy(() -> RoomFile.parse("my.room", List.of("# first", "start 0 0 0", line)))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("my.room, line 3: " + message);
    }

    @Test
    void aBlockedStartNamesTheRemedy() {
        assertThatThrownBy(() -> RoomFile.parse("my.room", List.of("wall 0 0 4000 3000")))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage(
                        "my.room: the robot cannot start at (0, 0) mm, 0 degrees: something solid or a cliff is within"
                                + " 170 mm; add or change the line 'start X Y HEADING'");
    }

    @Test
    void aFileThatIsNotTextIsRefused(@TempDir Path folder) throws IOException {
        Path binary = Files.write(folder.resolve("room.png"), new byte[] {(byte) 0x89, (byte) 0xFF, 0});
        assertThatThrownBy(() -> RoomFile.read(binary)).hasMessage(binary + ": is not a text file in UTF-8");
        assertThatThrownBy(() -> RoomFile.read(folder))
                .hasMessage(folder + ": cannot be read; it must be an existing, readable text file");
    }
}
