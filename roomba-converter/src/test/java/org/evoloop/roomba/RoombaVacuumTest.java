package org.evoloop.roomba;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.util.EnumSet;
import java.util.List;
import org.evoloop.PaperPair;
import org.evoloop.RoombaPair;
import org.evoloop.evolution.ModelPair;
import org.evoloop.mqtt.BrokerAddress;
import org.evoloop.mqtt.HomeAssistant;
import org.evoloop.mqtt.Vacuum.Activity;
import org.evoloop.mqtt.Vacuum.Order;
import org.evoloop.roomba.move.MoveOptions;
import org.evoloop.roomba.move.StartPointSensor;
import org.evoloop.roomba.simulator.robot.RobotOptions;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** What the vacuum offers, shows and refuses; {@code AtHomeTest} has what it presses. */
class RoombaVacuumTest {
    private static final List<Order> ENDING = List.of(Order.STOP, Order.PAUSE, Order.RETURN_TO_BASE);

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
        return new RoombaVacuum(
                new HomeAssistant(roomba.roomba.converter(), BrokerAddress.parse("mqtt://localhost")),
                roomba.roomba.session(),
                roomba.roomba.converter());
    }

    private void take(ModelPair models) {
        roomba.close();
        roomba = with(models);
        vacuum = vacuum();
    }

    private Activity shown() {
        return vacuum.activity(roomba.roomba.converter().status());
    }

    @AfterEach
    void close() {
        roomba.close();
    }

    @Test
    void itOffersWhatTheNewModelCanDo() {
        assertThat(vacuum.commands()).isEqualTo(EnumSet.allOf(Order.class));
        take(RoombaPair.of("guest"));
        assertThat(vacuum.commands()).as("CLEAN does nothing in On").doesNotContain(Order.START);
        take(PaperPair.cleaningRobot());
        assertThat(vacuum.commands()).as("there is no dock").doesNotContain(Order.RETURN_TO_BASE);
    }

    @Test
    void whatEndsSomethingLeavesARobotThatIsOff() {
        vacuum.perform(Order.STOP);
        vacuum.perform(Order.PAUSE);
        assertThatThrownBy(() -> vacuum.perform(Order.RETURN_TO_BASE)).hasMessageContaining("the robot is off");
        assertThat(roomba.advance(Duration.ofSeconds(1)).states()).isEqualTo(SteppedRoomba.at("Off", "Off"));
        assertThat(shown()).isEqualTo(Activity.IDLE);
    }

    @Test
    void whatEndsSomethingLeavesARobotOnItsDock() {
        roomba.robot.dock();
        roomba.advance(Duration.ofSeconds(2));
        ENDING.forEach(vacuum::perform);
        roomba.mute(true).advance(Duration.ofSeconds(5));
        assertThat(roomba.states()).isEqualTo(SteppedRoomba.at("Asleep", "Asleep"));
        ENDING.forEach(vacuum::perform);
        assertThat(shown()).isEqualTo(Activity.DOCKED);
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
        assertThatThrownBy(() -> vacuum.perform(Order.STOP)).hasMessageContaining("would drive it off its base");
        assertThat(shown()).isEqualTo(Activity.DOCKED);
    }

    @Test
    void aPauseOfARobotAtRestIsNone() {
        roomba.press(RobotEvents.CLEAN).advance(Duration.ofSeconds(1));
        vacuum.perform(Order.PAUSE);
        assertThat(shown()).isEqualTo(Activity.IDLE);
    }

    @Test
    void aRobotThatIsSilentOnItsDockIsDockedWhateverItsModelHas() {
        take(PaperPair.cleaningRobot());
        roomba.robot.dock();
        roomba.advance(Duration.ofSeconds(2)).mute(true).advance(Duration.ofSeconds(30));
        assertThat(roomba.roomba.session().isUp()).isFalse();
        assertThat(shown()).isEqualTo(Activity.DOCKED);
        roomba.robot.undock();
        roomba.mute(false).advance(Duration.ofSeconds(10)).mute(true).advance(Duration.ofSeconds(30));
        assertThat(shown()).isEqualTo(Activity.ERROR);
    }

    @Test
    void aRobotWhoseCableIsPulledOnItsDockIsAnError() {
        roomba.robot.dock();
        roomba.advance(Duration.ofSeconds(2)).unplug();
        roomba.advance(Duration.ofSeconds(2));
        assertThat(shown()).isEqualTo(Activity.ERROR);
    }
}
