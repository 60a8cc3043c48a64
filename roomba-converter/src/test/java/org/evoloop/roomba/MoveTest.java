package org.evoloop.roomba;

import static org.assertj.core.api.Assertions.assertThat;
import static org.evoloop.roomba.MoveTrip.box;
import static org.evoloop.roomba.MoveTrip.pose;
import static org.evoloop.roomba.MoveTrip.room;
import static org.evoloop.roomba.SteppedRoomba.at;

import java.time.Duration;
import java.util.function.BooleanSupplier;
import org.evoloop.PaperPair;
import org.evoloop.roomba.move.MoveOptions;
import org.evoloop.roomba.oi.Button;
import org.evoloop.roomba.oi.OiMode;
import org.evoloop.roomba.simulator.robot.RobotOptions;
import org.evoloop.roomba.simulator.room.Pose;
import org.evoloop.roomba.simulator.room.Room;
import org.evoloop.roomba.simulator.room.Shape;
import org.junit.jupiter.api.Test;

/** Move with a camera, from the converter's state machines to the robot's wheels. */
class MoveTest {
    private static final Pose MARKER = pose(3_998, 1_500, 180);
    private static final Duration LIMIT = Duration.ofMinutes(5);

    private static void assertArrives(MoveTrip trip) {
        assertThat(trip.ends(LIMIT)).as("left Move").isTrue();
        assertThat(trip.stepped.states()).isEqualTo(at("Spot", "Spot"));
        assertThat(trip.missMm()).isLessThan(50);
        assertThat(trip.missDeg()).isLessThan(3);
        assertThat(trip.fastestTouchMmPerS()).isLessThan(100);
    }

    @Test
    void turnsUntilItSeesTheMarkerAndStopsBeforeIt() {
        for (int heading = 0; heading < 360; heading += 45) {
            try (MoveTrip trip = MoveTrip.in(room(pose(1_500, 1_000, heading)), MARKER)) {
                assertArrives(trip);
            }
        }
    }

    @Test
    void backsAwayFromAMarkerThatIsTooNear() {
        try (MoveTrip trip = MoveTrip.in(room(pose(3_700, 1_500, 0)), MARKER)) {
            assertArrives(trip);
        }
    }

    @Test
    void goesRoundObstaclesBesideItsLineOfSight() {
        Room beside = room(pose(1_000, 1_500, 0), box(Shape.Kind.OBSTACLE, 2_000, 1_560, 2_200, 2_200));
        try (MoveTrip trip = MoveTrip.in(beside, MARKER)) {
            assertArrives(trip);
        }
    }

    @Test
    void goesElsewhereWhenTheMarkerIsHidden() {
        Room hidden = room(pose(600, 1_500, 0), box(Shape.Kind.OBSTACLE, 2_000, 900, 2_200, 2_100));
        try (MoveTrip trip = new MoveTrip(
                hidden,
                MARKER,
                PaperPair.cleaningRobot(),
                MoveOptions.defaults().withLimit(Duration.ofMinutes(5)),
                1)) {
            assertThat(trip.ends(Duration.ofMinutes(5))).isTrue();
            assertThat(trip.missMm()).isLessThan(50);
        }
    }

    @Test
    void backsOffFromACliffAndGoesRoundIt() {
        Room hole = room(pose(1_000, 1_500, 0), box(Shape.Kind.CLIFF, 2_000, 1_300, 2_300, 1_700));
        try (MoveTrip trip = MoveTrip.in(hole, MARKER)) {
            assertArrives(trip);
        }
    }

    @Test
    void standsWhenNothingIsFoundAndIsOnIfTheModelHasNoEventForThat() {
        try (MoveTrip trip = MoveTrip.in(room(pose(1_500, 1_000, 0)), null)) {
            trip.advance(LIMIT.plusSeconds(5));
            assertThat(trip.stepped.states()).isEqualTo(at("On", "On"));
            assertThat(trip.stands()).isTrue();
            assertThat(trip.truth().oiMode()).isEqualTo(OiMode.SAFE);
            assertThat(trip.fastestTouchMmPerS()).isLessThan(100);
        }
    }

    @Test
    void raisesTimeoutWhenNothingIsFoundIfTheModelHasIt() {
        MoveOptions short20 = MoveOptions.defaults().withLimit(Duration.ofSeconds(20));
        try (MoveTrip trip = new MoveTrip(room(pose(1_500, 1_000, 0)), null, MoveTrip.withTimeout(), short20, 1)) {
            trip.advance(Duration.ofSeconds(19));
            assertThat(trip.isMoving()).isTrue();
            trip.advance(Duration.ofSeconds(2));
            assertThat(trip.stepped.states()).isEqualTo(at("On", "On"));
            assertThat(trip.stands()).isTrue();
        }
    }

    @Test
    void stopsWhileNoFrameArrivesAndContinuesWhenTheyArriveAgain() {
        try (MoveTrip trip = MoveTrip.in(room(pose(1_000, 1_500, 0)), MARKER)) {
            trip.untilItDrives();
            trip.camera().setStalled(true);
            trip.advance(Duration.ofMillis(500));
            assertThat(trip.stands()).isTrue();
            trip.advance(Duration.ofSeconds(10));
            assertThat(trip.stands()).isTrue();
            trip.camera().setStalled(false);
            assertArrives(trip);
        }
    }

    @Test
    void looksAgainForAMarkerThatIsTakenAwayWhileItApproaches() {
        try (MoveTrip trip = MoveTrip.in(room(pose(1_000, 1_500, 0)), MARKER)) {
            trip.untilItDrives();
            trip.camera().moveMarker(null);
            trip.advance(Duration.ofMillis(1_500));
            assertThat(trip.truth().rightMmPerS() + trip.truth().leftMmPerS()).isLessThan(60);
            trip.camera().moveMarker(MARKER);
            assertArrives(trip);
        }
    }

    @Test
    void endsWhenTheRobotIsLifted() {
        try (MoveTrip trip =
                new MoveTrip(room(pose(1_000, 1_500, 0)), MARKER, MoveTrip.withTimeout(), MoveOptions.defaults(), 1)) {
            trip.untilItDrives();
            trip.stepped.robot.lift();
            trip.advance(Duration.ofMillis(500));
            assertThat(trip.stepped.states()).isEqualTo(at("On", "On"));
            trip.stepped.robot.setDown();
            trip.advance(Duration.ofSeconds(5));
            assertThat(trip.stands()).isTrue();
            assertThat(trip.truth().oiMode()).isEqualTo(OiMode.SAFE);
        }
    }

    @Test
    void theWheelsStopWhenTheCameraFails() {
        try (MoveTrip trip =
                new MoveTrip(room(pose(1_000, 1_500, 0)), MARKER, MoveTrip.withTimeout(), MoveOptions.defaults(), 1)) {
            trip.untilItDrives();
            trip.camera().breakDown(new IllegalStateException("torn off"));
            trip.advance(Duration.ofMillis(500));
            assertThat(trip.stands()).isTrue();
            assertThat(trip.stepped.states()).isEqualTo(at("On", "On"));
        }
    }

    @Test
    void theWheelsStopWhenTheConverterIsStopped() {
        try (MoveTrip trip = MoveTrip.in(room(pose(1_000, 1_500, 0)), MARKER)) {
            trip.untilItDrives();
            trip.stepped.roomba.converter().stop();
            trip.advance(Duration.ofMillis(300));
            assertThat(trip.stands()).isTrue();
            assertThat(trip.truth().oiMode()).isEqualTo(OiMode.PASSIVE);
        }
    }

    @Test
    void searchesAgainAfterTheCableWasPulledForAWhile() {
        try (MoveTrip trip = MoveTrip.in(room(pose(1_000, 1_500, 90)), MARKER)) {
            trip.advance(Duration.ofSeconds(1));
            trip.stepped.unplug();
            trip.advance(Duration.ofSeconds(5));
            trip.stepped.replug();
            assertArrives(trip);
        }
    }

    @Test
    void theWheelsStopWhileTheRobotIsSilentAlthoughTheCameraSees() {
        try (MoveTrip trip = MoveTrip.in(room(pose(1_000, 1_500, 0)), MARKER)) {
            trip.untilItDrives();
            trip.stepped.mute(true);
            trip.advance(Duration.ofMillis(400));
            assertThat(trip.stands()).isTrue();
            assertThat(trip.truth().oiMode()).as("not stopped by asking anew").isEqualTo(OiMode.SAFE);
            trip.advance(Duration.ofMillis(300));
            assertThat(trip.stands()).isTrue();
            trip.stepped.mute(false);
            assertArrives(trip);
        }
    }

    @Test
    void theWheelsStopWhileTheRobotIsSilentOnItsWayByDeadReckoning() {
        try (SteppedRoomba stepped = new SteppedRoomba(RobotOptions.defaults(), 2_000, 500)) {
            stepped.robotPress(Button.CLEAN).robotPress(Button.SPOT);
            BooleanSupplier drives =
                    () -> stepped.truth().leftMmPerS() != 0 || stepped.truth().rightMmPerS() != 0;
            stepped.until(drives, Duration.ofSeconds(10)).mute(true).advance(Duration.ofMillis(400));
            assertThat(drives.getAsBoolean()).isFalse();
            stepped.mute(false).until(drives, Duration.ofSeconds(1));
            stepped.until(() -> stepped.states().equals(at("Spot", "Spot")), LIMIT);
        }
    }
}
