package org.evoloop.roomba.simulator.robot;

import static org.assertj.core.api.Assertions.assertThat;
import static org.evoloop.roomba.oi.OiMode.FULL;
import static org.evoloop.roomba.oi.OiMode.PASSIVE;
import static org.evoloop.roomba.oi.OiMode.SAFE;

import java.util.List;
import org.evoloop.roomba.oi.ActuatorCommand.DriveDirect;
import org.evoloop.roomba.oi.ActuatorCommand.Motors;
import org.evoloop.roomba.oi.Command;
import org.evoloop.roomba.oi.OiMode;
import org.evoloop.roomba.oi.Packet;
import org.evoloop.roomba.simulator.room.Point;
import org.evoloop.roomba.simulator.room.Pose;
import org.evoloop.roomba.simulator.room.Room;
import org.evoloop.roomba.simulator.room.Shape;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What ends Safe mode automatically, and what does not (specification, "Safe Mode"). */
class SafetyTest {
    private static final Pose EDGE_AHEAD = new Pose(0, 0, 0);

    /** With a wall or a cliff half a metre ahead of the origin. */
    private static RobotOptions ahead(Shape.Kind kind) {
        Shape shape = new Shape(
                kind, List.of(new Point(500, -900), new Point(900, -900), new Point(900, 900), new Point(500, 900)));
        return RobotOptions.builder()
                .room(Room.of(List.of(shape), null, EDGE_AHEAD))
                .build();
    }

    private static void assertStopped(Bench bench) {
        bench.seconds(0.5);
        assertThat(bench.state().leftMmPerS()).isZero();
        assertThat(bench.state().rightMmPerS()).isZero();
        assertThat(bench.query(Packet.MAIN_BRUSH_CURRENT)).isZero();
    }

    @Test
    void aCliffAheadEndsSafeAndStopsAllMotorsBeforeTheRobotFalls() {
        Bench bench = Bench.in(SAFE, ahead(Shape.Kind.CLIFF))
                .send(new DriveDirect(500, 500), new Motors(7))
                .seconds(2);
        assertThat(bench.state().oiMode()).isEqualTo(PASSIVE);
        assertThat(bench.query(Packet.CLIFF_FRONT_LEFT)).isEqualTo(1);
        assertThat(bench.query(Packet.CLIFF_FRONT_RIGHT_SIGNAL)).isLessThan(100);
        assertThat(bench.state().surroundings().wheelDrops()).isEmpty();
        assertStopped(bench);
    }

    @Test
    void fromACliffTheRobotMayBackAwayInSafe() {
        Bench bench = Bench.in(SAFE, ahead(Shape.Kind.CLIFF))
                .send(new DriveDirect(300, 300))
                .seconds(3)
                .send(Bench.SAFE);
        assertThat(bench.state().oiMode()).isEqualTo(SAFE);
        bench.send(new DriveDirect(-200, -200)).seconds(1);
        assertThat(bench.state().oiMode()).isEqualTo(SAFE);
        assertThat(bench.state().surroundings().cliffs()).isEmpty();
    }

    @ParameterizedTest
    @CsvSource({"100, 100, PASSIVE", "-200, -20, PASSIVE", "-200, 200, PASSIVE", "-200, -200, SAFE", "-200, -80, SAFE"})
    void atACliffForwardAndTightTurnsEndSafe(int rightMmPerS, int leftMmPerS, OiMode mode) {
        Bench bench = Bench.in(SAFE, ahead(Shape.Kind.CLIFF));
        bench.robot.place(new Pose(360, 0, 0));
        bench.ticks(5);
        assertThat(bench.state().oiMode()).as("at rest").isEqualTo(SAFE);
        bench.send(new DriveDirect(rightMmPerS, leftMmPerS)).ticks(14);
        assertThat(bench.state().oiMode()).isEqualTo(mode);
    }

    @Test
    void aBumpDoesNotEndSafe() {
        Bench bench = Bench.in(SAFE, ahead(Shape.Kind.WALL))
                .send(new DriveDirect(300, 300))
                .seconds(3);
        assertThat(bench.query(Packet.BUMPS_AND_WHEEL_DROPS)).isEqualTo(3);
        assertThat(bench.state().oiMode()).isEqualTo(SAFE);
        assertThat(bench.state().leftMmPerS()).as("the wheels slip").isGreaterThan(250);
        assertThat(bench.state().xMm()).isBetween(329.0, 331.0);
    }

    @Test
    void aWheelDropEndsSafeAndFullLetsTheRobotFall() {
        Bench safe =
                Bench.in(SAFE).send(new DriveDirect(300, 300), new Motors(7)).seconds(1);
        safe.robot.lift();
        safe.ticks(1);
        assertThat(safe.state().oiMode()).isEqualTo(PASSIVE);
        assertThat(safe.query(Packet.BUMPS_AND_WHEEL_DROPS)).isEqualTo(12);
        assertStopped(safe);
        safe.send(Bench.SAFE);
        assertThat(safe.state().oiMode()).as("as long as it hangs").isEqualTo(PASSIVE);
        safe.robot.setDown();
        safe.send(Bench.SAFE).ticks(1);
        assertThat(safe.state().oiMode()).isEqualTo(SAFE);

        Bench full = Bench.in(FULL, ahead(Shape.Kind.CLIFF))
                .send(new DriveDirect(300, 300))
                .seconds(5);
        assertThat(full.state().oiMode()).isEqualTo(FULL);
        assertThat(full.query(Packet.BUMPS_AND_WHEEL_DROPS)).isEqualTo(12);
        assertThat(full.state().xMm()).as("on its belly over the edge").isBetween(500.0, 510.0);
    }

    @Test
    void onTheDockSafeBouncesBackAndFullDoesNot() {
        Bench bench = Bench.in(PASSIVE);
        bench.robot.dock();
        bench.ticks(2).send(Bench.SAFE);
        assertThat(bench.state().oiMode()).isEqualTo(PASSIVE);
        assertThat(bench.state().activity()).isEqualTo(RobotActivity.ON);
        bench.send(Bench.FULL).seconds(1);
        assertThat(bench.state().oiMode()).isEqualTo(FULL);
        bench.send(Bench.SAFE);
        assertThat(bench.state().oiMode()).isEqualTo(PASSIVE);
    }

    @Test
    void dockingByForceEndsSafe() {
        Bench bench = Bench.in(SAFE).send(new DriveDirect(200, 200)).seconds(1);
        bench.robot.dock();
        bench.ticks(1);
        assertThat(bench.state().oiMode()).isEqualTo(PASSIVE);
        assertStopped(bench);
    }

    @Test
    void wheelCommandsOutOfTheirRangeAreObeyedAsFarAsTheyGo() {
        Bench bench = Bench.in(FULL);
        byte[] drive = {(byte) 137, 3, 0, (byte) 0x80, 0};
        bench.robot.receive(drive, drive.length);
        bench.seconds(1);
        assertThat(bench.state().leftMmPerS()).isEqualTo(500);
        assertThat(bench.query(Packet.REQUESTED_VELOCITY)).isEqualTo(500);
        Bench passive = Bench.in(PASSIVE);
        passive.robot.receive(drive, drive.length);
        assertThat(passive.seconds(1).state().leftMmPerS()).isZero();
    }

    @Test
    void withAStrictModeWindowCommandsRightAfterAChangeOfModeAreIgnored() {
        Bench bench = new Bench(RobotOptions.builder().strictModeWindow(true).build());
        bench.send(Bench.START, Bench.SAFE);
        assertThat(bench.state().oiMode()).isEqualTo(PASSIVE);
        bench.ticks(1).send(Bench.SAFE, new DriveDirect(200, 200)).seconds(1);
        assertThat(bench.state().oiMode()).isEqualTo(SAFE);
        assertThat(bench.state().leftMmPerS()).isZero();
        bench.send(new DriveDirect(200, 200), new Motors(7)).seconds(1);
        assertThat(bench.state().leftMmPerS()).isPositive();
        bench.send(new Command.Reset()).seconds(4.1).send(Bench.START);
        assertThat(bench.state().oiMode()).isEqualTo(PASSIVE);
    }
}
