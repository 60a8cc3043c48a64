package org.evoloop.roomba;

import static org.assertj.core.api.Assertions.assertThat;
import static org.evoloop.roomba.MoveTrip.pose;
import static org.evoloop.roomba.MoveTrip.room;
import static org.evoloop.roomba.SteppedRoomba.at;

import java.time.Duration;
import org.evoloop.PaperPair;
import org.evoloop.evolution.ModelPair;
import org.evoloop.roomba.move.MoveOptions;
import org.evoloop.roomba.oi.Button;
import org.evoloop.roomba.oi.OiMode;
import org.evoloop.roomba.simulator.robot.RobotActivity;
import org.evoloop.roomba.simulator.room.Pose;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.StateMachineBuilder;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Using the robot's own buttons, or lifting it, ends a Move at once, whatever the models say. */
class PersonWinsTest {
    private static final Pose MARKER = pose(3_998, 1_500, 180);
    private static final Duration AT_ONCE = Duration.ofMillis(300);

    private static MoveTrip trip(ModelPair models) {
        MoveTrip trip = new MoveTrip(room(pose(1_000, 1_500, 0)), MARKER, models, MoveOptions.defaults(), 1);
        trip.untilItDrives();
        return trip;
    }

    /** The paper's models with this transition from Move. */
    private static ModelPair with(String event, String target) {
        StateMachine evolved = PaperPair.cleaningRobot().evolved();
        StateMachineBuilder builder = StateMachine.named("more").initial("Off");
        evolved.transitions().forEach(transition -> builder.transition(transition, ""));
        return new ModelPair(
                PaperPair.cleaningRobot().original(),
                builder.transition("Move", event, target).build());
    }

    private static void assertStandsFor(MoveTrip trip, Duration duration) {
        for (long passed = 0; passed < duration.toMillis(); passed += 15) {
            trip.advance(Duration.ofMillis(15));
            assertThat(trip.stands()).isTrue();
        }
    }

    @ParameterizedTest
    @EnumSource(
            value = Button.class,
            names = {"CLEAN", "SPOT", "DOCK", "DAY"})
    void aPressOfAnyButtonStopsTheRobotWhichIsOnThen(Button button) {
        try (MoveTrip trip = trip(PaperPair.cleaningRobot())) {
            trip.stepped.robot.press(button);
            trip.advance(AT_ONCE);
            assertStandsFor(trip, Duration.ofSeconds(10));
            assertThat(trip.stepped.states()).isEqualTo(at("On", "On"));
            assertThat(trip.truth().oiMode()).isEqualTo(OiMode.SAFE);
            trip.stepped.press(RobotEvents.CLEAN).advance(Duration.ofSeconds(1));
            assertThat(trip.stepped.states()).isEqualTo(at("Clean", "Clean"));
            assertThat(trip.truth().activity()).isEqualTo(RobotActivity.CLEAN);
        }
    }

    @Test
    void aTimeoutIsNotForPeople() {
        try (MoveTrip trip = trip(with("timeout", "Spot"))) {
            trip.stepped.robot.press(Button.CLEAN);
            trip.advance(AT_ONCE);
            assertStandsFor(trip, Duration.ofSeconds(3));
            assertThat(trip.stepped.states()).isEqualTo(at("On", "On"));
        }
    }

    @Test
    void aModelThatWouldDriveOnIsOverruled() {
        try (MoveTrip trip = trip(with("Clean", "Move"))) {
            trip.stepped.robot.press(Button.CLEAN);
            trip.advance(AT_ONCE);
            assertStandsFor(trip, Duration.ofSeconds(3));
            assertThat(trip.stepped.states()).isEqualTo(at("On", "On"));
        }
    }

    @Test
    void aModelThatKnowsThePressLeadsOn() {
        try (MoveTrip trip = trip(with("Clean", "Spot"))) {
            trip.stepped.robot.press(Button.CLEAN);
            trip.advance(Duration.ofSeconds(1));
            assertThat(trip.stepped.states()).isEqualTo(at("Spot", "Spot"));
            assertThat(trip.truth().activity()).isEqualTo(RobotActivity.SPOT);
        }
    }

    @Test
    void aLiftedRobotStandsStillWhenItIsSetDown() {
        try (MoveTrip trip = trip(PaperPair.cleaningRobot())) {
            trip.stepped.robot.lift();
            trip.advance(AT_ONCE);
            assertThat(trip.stepped.states()).isEqualTo(at("On", "On"));
            trip.stepped.robot.setDown();
            assertStandsFor(trip, Duration.ofSeconds(5));
            assertThat(trip.stepped.states()).isEqualTo(at("On", "On"));
        }
    }

    @ParameterizedTest
    @EnumSource(
            value = Button.class,
            names = {"CLEAN", "SPOT"})
    void aRobotThatHasSlippedOutOfControlDoesWhatItsButtonSays(Button button) {
        try (MoveTrip trip = trip(PaperPair.cleaningRobot())) {
            byte[] start = {(byte) 128};
            trip.stepped.robot.receive(start, start.length);
            trip.advance(Duration.ofMillis(60));
            trip.stepped.robot.press(button);
            trip.advance(Duration.ofSeconds(5));
            String doing = button == Button.CLEAN ? "Clean" : "Spot";
            assertThat(trip.stepped.states()).isEqualTo(at(doing, doing));
            assertThat(trip.truth().activity().name()).isEqualToIgnoringCase(doing);
        }
    }
}
