package org.evoloop.roomba.simulator;

import static org.assertj.core.api.Assertions.assertThat;

import org.evoloop.roomba.simulator.robot.RobotOptions;
import org.evoloop.roomba.simulator.robot.SimulatedRoomba;
import org.evoloop.roomba.simulator.room.Marker;
import org.evoloop.roomba.simulator.room.Pose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class WorldCommandsTest {
    private final SimulatedRoomba robot = new SimulatedRoomba(RobotOptions.defaults(), bytes -> {});
    private final WorldCommands world = new WorldCommands(robot);

    @Test
    void theStateIsOneLineOfJsonWithStableKeys() {
        assertThat(world.execute("state"))
                .isEqualTo("{\"timeMillis\":0,\"activity\":\"off\",\"oiMode\":\"off\",\"xMm\":0.0,\"yMm\":0.0,"
                        + "\"headingDeg\":0.00,\"leftMmPerS\":0.0,\"rightMmPerS\":0.0,\"pressed\":[],"
                        + "\"streaming\":false,\"docked\":false,\"charging\":false,\"lifted\":false,"
                        + "\"asleep\":false,\"batteryPercent\":100,\"bumps\":[],\"cliffs\":[],\"wheelDrops\":[],"
                        + "\"baud\":115200}");
    }

    @Test
    void pressesAreSeenInTheState() {
        assertThat(world.execute("press clean")).isEqualTo("ok");
        ticks(9);
        assertThat(world.execute("state")).contains("\"activity\":\"on\"", "\"pressed\":[\"clean\"]");
        ticks(1);
        assertThat(world.execute("state")).contains("\"timeMillis\":150,", "\"pressed\":[]");
        assertThat(world.execute("  press   spot  1500 ")).isEqualTo("ok");
        ticks(99);
        assertThat(world.execute("state")).contains("\"activity\":\"spot\"", "\"pressed\":[\"spot\"]");
        assertThat(world.execute("press dock")).isEqualTo("ok");
        assertThat(world.execute("state")).contains("\"activity\":\"on\"", "\"pressed\":[\"spot\",\"dock\"]");
    }

    private void ticks(int count) {
        for (int i = 0; i < count; i++) {
            robot.tick();
        }
    }

    @Test
    void peopleCarryTheRobotAbout() {
        assertThat(world.execute("place 120 -30.5 90")).isEqualTo("ok");
        assertThat(world.execute("state")).contains("\"xMm\":120.0,\"yMm\":-30.5,\"headingDeg\":90.00");
        assertThat(world.execute("lift")).isEqualTo("ok");
        assertThat(world.execute("state"))
                .contains("\"lifted\":true", "\"wheelDrops\":[\"left\",\"right\"]", "\"cliffs\":[\"left\",");
        assertThat(world.execute("set-down")).isEqualTo("ok");
        assertThat(world.execute("state")).contains("\"lifted\":false", "\"wheelDrops\":[]");
        assertThat(world.execute("dock")).isEqualTo("ok");
        assertThat(world.execute("state")).contains("\"docked\":true", "\"xMm\":120.0,\"yMm\":-30.5,");
        assertThat(world.execute("undock")).isEqualTo("ok");
        assertThat(world.execute("state")).contains("\"docked\":false", "\"xMm\":120.0,\"yMm\":-530.5,");
        assertThat(world.execute("dock")).as("back to the same dock").isEqualTo("ok");
        assertThat(world.execute("state")).contains("\"docked\":true", "\"xMm\":120.0,\"yMm\":-30.5,");
    }

    @Test
    void helpNamesEveryCommand() {
        assertThat(world.execute("help"))
                .isEqualTo("press clean|spot|dock [MILLIS]; lift; set-down; place X Y HEADING; dock; undock; unplug; "
                        + "replug; move-marker X Y HEADING; cover-marker; uncover-marker; camera "
                        + "stall|resume|unplug|replug|damage P; state; help");
    }

    @Test
    void peopleCarryTheMarkerAboutAndCoverIt() {
        assertThat(world.execute("move-marker 1400 500 180")).isEqualTo("ok");
        assertThat(marker()).isEqualTo(Marker.at(new Pose(1_400, 500, Math.PI)));
        assertThat(world.execute("cover-marker")).isEqualTo("ok");
        assertThat(world.execute("move-marker 0 0 0")).isEqualTo("ok");
        assertThat(marker()).isEqualTo(Marker.at(Pose.ORIGIN).covered(true));
        assertThat(world.execute("uncover-marker")).isEqualTo("ok");
        assertThat(marker().covered()).isFalse();
    }

    private Marker marker() {
        return robot.state().surroundings().room().marker().orElseThrow();
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '#',
            value = {
                "''              # error: '' is not a command; there are press clean|spot|dock [MILLIS]; lift; set-down;"
                        + " place X Y HEADING; dock; undock; unplug; replug; move-marker X Y HEADING; cover-marker;"
                        + " uncover-marker; camera stall|resume|unplug|replug|damage P; state; help",
                "lift it         # error: the command is 'lift'",
                "place 1 2       # error: the command is 'place X Y HEADING'",
                "place 1 two 3   # error: Y is 'two'; allowed is -100000 to 100000",
                "place 1e9 2 3   # error: X is '1e9'; allowed is -100000 to 100000",
                "place 0 0 999999 # error: HEADING is '999999'; allowed is -100000 to 100000",
                "undock          # error: the robot is not on a dock",
                "unplug          # error: this robot has no cable",
                "press           # error: the command is 'press clean|spot|dock [MILLIS]'",
                "press clock     # error: 'clock' is not a button; there are clean, spot and dock",
                "press clean 0   # error: MILLIS is '0'; allowed is 1 to 60000 ms",
                "press clean 1e9 # error: MILLIS is '1e9'; allowed is 1 to 60000 ms",
                "camera stall    # error: this robot has no camera",
                "cover-marker    # error: there is no marker in the room; hang one up with 'move-marker X Y HEADING'",
                "move-marker 1 2 # error: the command is 'move-marker X Y HEADING'",
                "state now       # error: the command is 'state'",
            })
    void mistakesAreAnsweredAndChangeNothing(String line, String answer) {
        String before = world.execute("state");
        assertThat(world.execute(line)).isEqualTo(answer);
        assertThat(world.execute("state")).isEqualTo(before);
    }
}
