package org.evoloop.roomba;

import static org.assertj.core.api.Assertions.assertThat;
import static org.evoloop.roomba.MoveTrip.pose;
import static org.evoloop.roomba.MoveTrip.room;
import static org.evoloop.roomba.SteppedRoomba.at;

import java.time.Duration;
import org.evoloop.PaperPair;
import org.evoloop.converter.Trouble;
import org.evoloop.roomba.move.MoveOptions;
import org.evoloop.roomba.simulator.robot.RobotActivity;
import org.evoloop.roomba.simulator.room.Pose;
import org.junit.jupiter.api.Test;

/** What happens after a Move that has not arrived. */
class MoveEndsTest {
    private static final Pose MARKER = pose(3_998, 1_500, 180);

    @Test
    void ifNothingIsFoundItIsWhereItBeganAndTheControllerContinuesFromThere() {
        MoveOptions soon = MoveOptions.defaults().withLimit(Duration.ofSeconds(5));
        try (MoveTrip trip = new MoveTrip(room(pose(1_500, 1_000, 0)), null, PaperPair.cleaningRobot(), soon, 1)) {
            trip.advance(Duration.ofSeconds(6));
            assertThat(trip.stepped.states()).isEqualTo(at("On", "On"));
            assertThat(trip.stepped.roomba.converter().status().troubles())
                    .containsExactly(new Trouble(
                            "function Move",
                            "Move.function: ended before the starting point: not found within 5 s",
                            1));
            trip.stepped.press(RobotEvents.SPOT);
            assertThat(trip.isMoving()).as("it can be tried again").isTrue();
            trip.advance(Duration.ofSeconds(6));
            trip.stepped.press(RobotEvents.CLEAN).advance(Duration.ofSeconds(1));
            assertThat(trip.stepped.states()).isEqualTo(at("Clean", "Clean"));
            assertThat(trip.truth().activity()).isEqualTo(RobotActivity.CLEAN);
        }
    }

    @Test
    void afterAStopOnTheWayTheRobotStandsStillAfterTheNextStart() {
        try (MoveTrip trip = MoveTrip.in(room(pose(1_000, 1_500, 0)), MARKER)) {
            trip.untilItDrives();
            trip.stepped.roomba.converter().stop();
            trip.advance(Duration.ofSeconds(1));
            trip.stepped.roomba.converter().start();
            trip.advance(Duration.ofMillis(100));
            assertThat(trip.stepped.states()).isEqualTo(at("On", "On"));
            for (int tick = 0; tick < 500; tick++) {
                trip.advance(Duration.ofMillis(15));
                assertThat(trip.stands()).isTrue();
            }
            trip.stepped.press(RobotEvents.SPOT);
            assertThat(trip.isMoving()).isTrue();
            trip.untilItDrives();
        }
    }
}
