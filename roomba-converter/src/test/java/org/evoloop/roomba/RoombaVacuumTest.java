package org.evoloop.roomba;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.util.List;
import org.evoloop.PaperPair;
import org.evoloop.RoombaPair;
import org.evoloop.converter.ConverterStatus;
import org.evoloop.evolution.ModelPair;
import org.evoloop.mqtt.home.HomeKind;
import org.evoloop.mqtt.home.HomeTable;
import org.evoloop.roomba.move.MoveOptions;
import org.evoloop.roomba.move.StartPointSensor;
import org.evoloop.roomba.simulator.robot.RobotOptions;
import org.evoloop.statemachine.Event;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** What the vacuum offers, shows and refuses; {@code AtHomeTest} has what it presses. */
class RoombaVacuumTest {
    private static final List<String> ENDING = List.of(RoombaVacuum.STOP, RoombaVacuum.PAUSE, RoombaVacuum.RETURN);

    private SteppedRoomba roomba = with(RoombaPair.of("home"));
    private RoombaVacuum vacuum = vacuum();

    private static SteppedRoomba with(ModelPair models) {
        return new SteppedRoomba(
                RobotOptions.builder().batteryPercent(80).build(),
                models,
                MoveOptions.defaults(),
                (robot, clock) -> StartPointSensor.byWheels(Scenario.START_X_MM, Scenario.START_Y_MM));
    }

    private RoombaVacuum vacuum() {
        return new RoombaVacuum(roomba.roomba.session(), roomba.roomba.converter());
    }

    private void take(ModelPair models) {
        roomba.close();
        roomba = with(models);
        vacuum = vacuum();
    }

    private HomeTable table() {
        List<String> events = roomba.roomba.converter().controllerEvents().stream()
                .map(Event::name)
                .toList();
        return HomeTable.of(
                vacuum.entity(), roomba.roomba.converter().knowledge().models(), events);
    }

    private String shown() {
        ConverterStatus status = roomba.roomba.converter().status();
        return vacuum.shown(status, table().shown(status.states().evolved()));
    }

    private boolean begins(String command) {
        return vacuum.begins(command, roomba.roomba.converter().status());
    }

    @AfterEach
    void close() {
        roomba.close();
    }

    @Test
    void itOffersWhatTheNewModelCanDo() {
        assertThat(table().commands()).containsExactlyElementsOf(HomeKind.VACUUM.commands());
        take(RoombaPair.of("guest"));
        assertThat(table().commands()).as("CLEAN does nothing in On").doesNotContain(RoombaVacuum.START);
        take(PaperPair.cleaningRobot());
        assertThat(table().commands()).as("there is no dock").doesNotContain(RoombaVacuum.RETURN);
    }

    @Test
    void whatEndsSomethingLeavesARobotThatIsOff() {
        assertThat(begins(RoombaVacuum.STOP)).isFalse();
        assertThat(begins(RoombaVacuum.PAUSE)).isFalse();
        assertThatThrownBy(() -> begins(RoombaVacuum.RETURN)).hasMessageContaining("the robot is off");
        assertThat(roomba.advance(Duration.ofSeconds(1)).states()).isEqualTo(SteppedRoomba.at("Off", "Off"));
        assertThat(shown()).isEqualTo("idle");
    }

    @Test
    void whatEndsSomethingLeavesARobotOnItsDock() {
        roomba.robot.dock();
        roomba.advance(Duration.ofSeconds(2));
        assertThat(ENDING).noneMatch(this::begins);
        roomba.mute(true).advance(Duration.ofSeconds(5));
        assertThat(roomba.states()).isEqualTo(SteppedRoomba.at("Asleep", "Asleep"));
        assertThat(ENDING).noneMatch(this::begins);
        assertThat(shown()).isEqualTo("docked");
    }

    @Test
    void aFunctionThatCouldOnlyEndOffTheDockContinues() {
        roomba.close();
        roomba = new SteppedRoomba(
                RobotOptions.builder().batteryPercent(15).build(),
                RoombaPair.of("home"),
                MoveOptions.defaults(),
                (robot, clock) -> StartPointSensor.byWheels(Scenario.START_X_MM, Scenario.START_Y_MM));
        vacuum = vacuum();
        roomba.press(RobotEvents.CLEAN).advance(Duration.ofSeconds(1));
        roomba.press(RobotEvents.SPOT).advance(Duration.ofSeconds(1));
        roomba.robot.dock();
        roomba.advance(Duration.ofSeconds(3));
        assertThat(roomba.states()).isEqualTo(SteppedRoomba.at("Charging", "ChargeThenMove"));
        assertThatThrownBy(() -> begins(RoombaVacuum.STOP)).hasMessageContaining("would drive it off its base");
        assertThat(shown()).isEqualTo("docked");
    }

    @Test
    void aPauseOfARobotAtRestIsNone() {
        roomba.press(RobotEvents.CLEAN).advance(Duration.ofSeconds(1));
        begins(RoombaVacuum.PAUSE);
        assertThat(shown()).isEqualTo("idle");
    }

    @Test
    void aRobotThatIsSilentOnItsDockIsDockedWhateverItsModelHas() {
        take(PaperPair.cleaningRobot());
        roomba.robot.dock();
        roomba.advance(Duration.ofSeconds(2)).mute(true).advance(Duration.ofSeconds(30));
        assertThat(roomba.roomba.session().isUp()).isFalse();
        assertThat(shown()).isEqualTo("docked");
        roomba.robot.undock();
        roomba.mute(false).advance(Duration.ofSeconds(10)).mute(true).advance(Duration.ofSeconds(30));
        assertThat(shown()).isEqualTo("error");
    }

    @Test
    void aRobotWhoseCableIsPulledOnItsDockIsAnError() {
        roomba.robot.dock();
        roomba.advance(Duration.ofSeconds(2)).unplug();
        roomba.advance(Duration.ofSeconds(2));
        assertThat(shown()).isEqualTo("error");
    }
}
