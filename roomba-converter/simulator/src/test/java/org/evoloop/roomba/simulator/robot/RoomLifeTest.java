package org.evoloop.roomba.simulator.robot;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Random;
import org.evoloop.roomba.oi.ActuatorCommand.DriveDirect;
import org.evoloop.roomba.oi.Command;
import org.evoloop.roomba.oi.OiMode;
import org.evoloop.roomba.oi.Packet;
import org.evoloop.roomba.oi.PacketGroup;
import org.evoloop.roomba.oi.SensorValues;
import org.evoloop.roomba.simulator.room.Pose;
import org.evoloop.roomba.simulator.room.Room;
import org.evoloop.roomba.simulator.room.RoomFile;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The robot in a room of 5 m by 4 m with a table, a plant, stairs and its dock. */
class RoomLifeTest {
    private static Room room = Room.OPEN;

    @BeforeAll
    static void furnish(@TempDir Path folder) throws Exception {
        room = RoomFile.read(Files.writeString(folder.resolve("room.txt"), """
                wall     0 0  5000 4000
                obstacle 1800 1500  2600 2100            # a table
                obstacle 3600 0  3900 900  4400 700      # a plant
                cliff    4200 2800  5000 4000            # stairs
                dock     270 3000 180
                start    1000 1000 0
                """));
    }

    private static Bench bench() {
        return Bench.in(OiMode.PASSIVE, RobotOptions.builder().room(room).build());
    }

    private static Bench at(double xMm, double yMm, double headingDeg) {
        Bench bench = bench();
        bench.robot.place(new Pose(xMm, yMm, Math.toRadians(headingDeg)));
        return bench;
    }

    private static SensorValues sensed(Bench bench) {
        return bench.stream(PacketGroup.GROUP_100).ticks(1).frames().get(0);
    }

    /** A random place with nothing near it. */
    private static Pose somewhere(Random random) {
        Pose pose;
        do {
            pose = new Pose(5_000 * random.nextDouble(), 4_000 * random.nextDouble(), 7 * random.nextDouble());
        } while (!room.isFree(pose) || (pose.xMm() > 4_000 && pose.yMm() > 2_600));
        return pose;
    }

    @Test
    void itBeginsAtTheRoomsStart() {
        assertThat(bench().state().pose()).isEqualTo(new Pose(1_000, 1_000, 0));
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
    void whateverItDoesItStaysInTheRoomAndOffTheStairs(long seed) {
        Random random = new Random(seed);
        for (Command command : List.of(new Command.Clean(), new Command.Spot(), new Command.SeekDock())) {
            Bench bench = bench();
            Pose from = somewhere(random);
            bench.robot.place(from);
            bench.send(command);
            for (int tick = 0; tick < 12_000; tick++) {
                RobotState state = bench.ticks(1).state();
                assertThat(state.surroundings().wheelDrops())
                        .as("seed %s: %s from %s at %s", seed, command, from, state)
                        .isEmpty();
                assertThat(room.touched(state.pose(), -1))
                        .as("seed %s: %s from %s at %s", seed, command, from, state)
                        .isEmpty();
            }
        }
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
    void itFindsItsDock(long seed) {
        Bench bench = bench();
        Pose from = somewhere(new Random(seed));
        bench.robot.place(from);
        bench.send(new Command.SeekDock());
        for (int second = 0; second < 1_200 && bench.state().activity() == RobotActivity.DOCK; second++) {
            bench.seconds(1);
        }
        assertThat(bench.state().activity()).as("seed %s from %s", seed, from).isEqualTo(RobotActivity.ON);
        assertThat(bench.seconds(1).state().charging())
                .as("seed %s from %s", seed, from)
                .isTrue();
    }

    @Test
    void cleaningComesToMostOfTheRoom() {
        Bench bench = bench().send(new Command.Clean());
        boolean[][] seen = new boolean[10][8];
        for (int tick = 0; tick < 60_000; tick++) {
            RobotState state = bench.ticks(1).state();
            seen[(int) (state.xMm() / 500)][(int) (state.yMm() / 500)] = true;
        }
        int squares = 0;
        for (boolean[] column : seen) {
            for (boolean square : column) {
                squares += square ? 1 : 0;
            }
        }
        assertThat(squares).as("of 80 squares of half a metre").isGreaterThan(50);
    }

    @Test
    void spotCleaningInACornerEndsInTime() {
        Bench bench = at(300, 300, 45).send(new Command.Spot()).seconds(46);
        assertThat(bench.state().activity()).isEqualTo(RobotActivity.ON);
        assertThat(bench.seconds(0.5).state().leftMmPerS()).isZero();
    }

    @Test
    void liftedItEndsWhatItDoes() {
        for (Command command : List.of(new Command.Clean(), new Command.Spot(), new Command.SeekDock())) {
            Bench bench = bench().send(command).seconds(3);
            bench.robot.lift();
            bench.ticks(1);
            assertThat(bench.state().activity()).as("%s", command).isEqualTo(RobotActivity.ON);
            double xMm = bench.state().xMm();
            bench.seconds(1);
            assertThat(bench.state().xMm()).as("in the air").isEqualTo(xMm);
            assertThat(bench.query(Packet.SIDE_BRUSH_CURRENT)).isZero();
        }
    }

    @Test
    void boxedInItGivesUp(@TempDir Path folder) throws Exception {
        Room box = RoomFile.read(Files.writeString(folder.resolve("box.txt"), "wall -175 -175 175 175\n"));
        Bench bench = Bench.in(OiMode.PASSIVE, RobotOptions.builder().room(box).build());
        bench.send(new Command.Clean()).seconds(120);
        assertThat(bench.state().activity()).isEqualTo(RobotActivity.ON);
    }

    @Test
    void theBumperShowsTheSide() {
        // Looking along y at the wall x = 0, which is then to the left; turned towards it, ahead to the left.
        assertThat(at(170.5, 2_000, 90).query(Packet.BUMPS_AND_WHEEL_DROPS)).isZero();
        assertThat(at(170.5, 2_000, 130).query(Packet.BUMPS_AND_WHEEL_DROPS)).isEqualTo(2);
        assertThat(at(170.5, 2_000, 180).query(Packet.BUMPS_AND_WHEEL_DROPS)).isEqualTo(3);
        assertThat(at(170.5, 2_000, 230).query(Packet.BUMPS_AND_WHEEL_DROPS)).isEqualTo(1);
        assertThat(at(170.5, 2_000, 0).query(Packet.BUMPS_AND_WHEEL_DROPS))
                .as("behind")
                .isZero();
        assertThat(at(175, 2_000, 180).query(Packet.BUMPS_AND_WHEEL_DROPS))
                .as("just not")
                .isZero();
    }

    @Test
    void theLightSensorsSeeWhatComesNear() {
        SensorValues free = sensed(at(1_000, 1_000, 0));
        assertThat(free.value(Packet.LIGHT_BUMPER)).isZero();
        assertThat(free.value(Packet.WALL)).isZero();
        SensorValues ahead = sensed(at(300, 2_000, 180));
        assertThat(ahead.value(Packet.LIGHT_BUMPER)).isEqualTo(0b011110);
        assertThat(ahead.value(Packet.LIGHT_BUMP_CENTER_LEFT_SIGNAL))
                .isEqualTo(ahead.value(Packet.LIGHT_BUMP_CENTER_RIGHT_SIGNAL))
                .isGreaterThan(ahead.value(Packet.LIGHT_BUMP_FRONT_LEFT_SIGNAL));
        SensorValues right = sensed(at(250, 2_000, -90));
        assertThat(right.value(Packet.WALL)).isEqualTo(1);
        assertThat(right.value(Packet.WALL_SIGNAL)).isBetween(1, 1_023);
        assertThat(right.value(Packet.LIGHT_BUMP_LEFT_SIGNAL)).isZero();
    }

    @Test
    void theCliffSensorsShowTheSide() {
        // The stairs' edge runs along x at y = 2800; looking along x they are to the left.
        SensorValues left = sensed(at(4_500, 2_700, 0));
        assertThat(left.value(Packet.CLIFF_LEFT)).isEqualTo(1);
        assertThat(left.value(Packet.CLIFF_RIGHT)).isZero();
        assertThat(left.value(Packet.CLIFF_LEFT_SIGNAL)).isLessThan(left.value(Packet.CLIFF_RIGHT_SIGNAL));
        SensorValues ahead = sensed(at(4_600, 2_670, 90));
        assertThat(ahead.value(Packet.CLIFF_FRONT_LEFT)).isEqualTo(1);
        assertThat(ahead.value(Packet.CLIFF_FRONT_RIGHT)).isEqualTo(1);
        assertThat(ahead.value(Packet.CLIFF_LEFT)).isZero();
        assertThat(sensed(at(4_500, 2_690, 180)).value(Packet.CLIFF_RIGHT)).isEqualTo(1);
    }

    @Test
    void alongAWallTheRobotSlides() {
        Bench bench =
                at(400, 500, 200).send(Bench.FULL, new DriveDirect(300, 300)).seconds(4);
        assertThat(bench.state().xMm()).isBetween(169.9, 170.1);
        assertThat(bench.state().yMm()).isLessThan(400);
        assertThat(bench.state().headingDeg()).isEqualTo(-160);
        assertThat(sensed(bench).bumpLeft()).isTrue();
    }
}
