package org.evoloop.roomba.simulator.room;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
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
    void withoutAStartItBeginsOnTheDockOrAtTheOrigin() {
        assertThat(RoomFile.parse("a", List.of()).start()).isEqualTo(Pose.ORIGIN);
        assertThat(RoomFile.parse("a", List.of("dock 100 200 90")).start()).isEqualTo(new Pose(100, 200, Math.PI / 2));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "sofa 1 2 3 4    | 'sofa' is unknown; a line begins with wall, obstacle, cliff, dock or start",
                "wall 1 2 3      | wall has 3 numbers; it needs two corners (a rectangle) or more (a polygon), each as X Y",
                "cliff           | cliff has 0 numbers; it needs two corners (a rectangle) or more (a polygon), each as X Y",
                "wall 1 2 3 four | 'four' is not a number",
                "wall 1 2 3 1e6  | '1e6' is too far away; allowed is -100000 to 100000",
                "wall 1 2 3 NaN  | 'NaN' is too far away; allowed is -100000 to 100000",
                "dock 1 2        | dock has 2 numbers; it needs three: X Y HEADING",
                "start 1 2 3     | there is a start already; remove one of the two",
            })
    void aMistakeNamesFileLineAndMend(String line, String message) {
        assertThatThrownBy(() -> RoomFile.parse("my.room", List.of("# first", "start 0 0 0", line)))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("my.room, line 3: " + message);
    }

    @Test
    void aStartInTheWayNamesTheMend() {
        assertThatThrownBy(() -> RoomFile.parse("my.room", List.of("wall 0 0 4000 3000")))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage(
                        "my.room: the robot cannot start at (0, 0) mm, 0 degrees: something solid or a cliff is within"
                                + " 170 mm; add or change the line 'start X Y HEADING'");
    }

    @Test
    void aFileThatIsNoTextIsRefused(@TempDir Path folder) throws IOException {
        Path binary = Files.write(folder.resolve("room.png"), new byte[] {(byte) 0x89, (byte) 0xFF, 0});
        assertThatThrownBy(() -> RoomFile.read(binary)).hasMessage(binary + ": is not a text file in UTF-8");
        assertThatThrownBy(() -> RoomFile.read(folder))
                .hasMessage(folder + ": cannot be read; it must be an existing, readable text file");
    }
}
