package org.evoloop.roomba;

import static org.assertj.core.api.Assertions.assertThat;
import static org.evoloop.roomba.SteppedRoomba.at;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.evoloop.RoombaPair;
import org.evoloop.converter.HistoryEntry;
import org.evoloop.converter.Trouble;
import org.evoloop.evolution.Occurrence;
import org.evoloop.function.Reading;
import org.evoloop.roomba.move.MoveOptions;
import org.evoloop.roomba.move.StartPointSensor;
import org.evoloop.roomba.oi.Button;
import org.evoloop.roomba.oi.OiMode;
import org.evoloop.roomba.simulator.robot.RobotActivity;
import org.evoloop.roomba.simulator.robot.RobotOptions;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A day of a robot with {@code models/roomba.xml#home}. */
class HomeTest {
    private SteppedRoomba roomba = at(100);

    private static SteppedRoomba at(int batteryPercent) {
        return new SteppedRoomba(
                RobotOptions.builder()
                        .spotDurationMillis(20_000)
                        .batteryPercent(batteryPercent)
                        .build(),
                RoombaPair.of("home"),
                MoveOptions.defaults(),
                (robot, clock) -> StartPointSensor.byWheels(Scenario.START_X_MM, Scenario.START_Y_MM));
    }

    @AfterEach
    void close() {
        roomba.close();
    }

    private void until(String original, String evolved, int seconds) {
        roomba.until(() -> roomba.states().equals(SteppedRoomba.at(original, evolved)), Duration.ofSeconds(seconds));
    }

    private Map<String, Object> readings() {
        return roomba.roomba.session().readings().stream().collect(Collectors.toMap(Reading::name, Reading::value));
    }

    private void switchOn() {
        roomba.press(RobotEvents.CLEAN).advance(Duration.ofSeconds(1));
        assertThat(roomba.states()).isEqualTo(SteppedRoomba.at("On", "On"));
    }

    @Test
    void aWorkingRobotGoesHomeOnCommand() {
        switchOn();
        roomba.press(RobotEvents.CLEAN).advance(Duration.ofSeconds(5));
        roomba.press(RobotEvents.DOCK).advance(Duration.ofSeconds(1));
        assertThat(roomba.states()).isEqualTo(SteppedRoomba.at("Dock", "Dock"));
        assertThat(roomba.truth().activity()).isEqualTo(RobotActivity.DOCK);

        roomba.robot.dock();
        until("Charging", "Charging", 3);

        assertThat(roomba.truth().oiMode()).isEqualTo(OiMode.PASSIVE);
        assertThat(readings()).containsEntry("docked", true).containsEntry("charging", true);
    }

    @Test
    void itGoesThereCleansTheSpotAndGoesHome() {
        switchOn();
        roomba.press("SpotThenDock");
        until("On", "GoThere", 1);
        until("Spot", "SpotThere", 60);
        assertThat(roomba.truth().pose().distanceMmTo(Scenario.START_X_MM, Scenario.START_Y_MM))
                .isLessThan(200);

        until("Dock", "Dock", 30);

        assertThat(roomba.truth().activity()).isEqualTo(RobotActivity.DOCK);
        assertThat(roomba.roomba.converter().history())
                .extracting(HistoryEntry::detail)
                .anyMatch(detail -> detail.contains("left GoThere at checking the place"));
    }

    @Test
    void fromItsDockItBacksOffFirst() {
        roomba.robot.dock();
        until("Charging", "Charging", 3);

        roomba.press(RobotEvents.SPOT);
        until("On", "Move", 10);

        roomba.until(() -> !roomba.truth().surroundings().docked(), Duration.ofSeconds(5));
        roomba.until(() -> roomba.truth().oiMode() == OiMode.SAFE, Duration.ofSeconds(1));
        until("Spot", "Spot", 60);
    }

    @ParameterizedTest
    @ValueSource(strings = {RobotEvents.CLEAN, RobotEvents.MAX, RobotEvents.SCHEDULE})
    void whileItLeavesItsDockTheDockIsNoNews(String event) {
        roomba.robot.dock();
        until("Charging", "Charging", 3);
        roomba.advance(Duration.ofSeconds(2));
        int before = roomba.roomba.converter().history().size();

        roomba.press(event).advance(Duration.ofSeconds(8));

        assertThat(roomba.truth().surroundings().docked()).isFalse();
        assertThat(roomba.roomba.converter().history().stream().skip(before))
                .extracting(entry -> entry.occurrence().label())
                .containsExactlyElementsOf(
                        event.equals(RobotEvents.SCHEDULE) ? List.of(event, RobotEvents.QUIET_OVER) : List.of(event));
    }

    @Test
    void aRobotThatFallsSilentOnItsDockIsAsleep() {
        roomba.robot.dock();
        until("Charging", "Charging", 3);

        roomba.mute(true);
        until("Asleep", "Asleep", 5);
        assertThat(roomba.roomba.session().isUp()).isTrue();
        assertThat(vacuum().shown(roomba.roomba.converter().status(), "idle")).isEqualTo("docked");

        roomba.mute(false);
        until("Charged", "Charged", 10);
    }

    private RoombaVacuum vacuum() {
        return new RoombaVacuum(roomba.roomba.session(), roomba.roomba.converter());
    }

    @Test
    void anUnusedRobotSleepsAndIsWokenByTheNextEvent() {
        switchOn();
        roomba.advance(Duration.ofSeconds(310));
        assertThat(roomba.truth().oiMode()).isEqualTo(OiMode.PASSIVE);
        roomba.advance(Duration.ofSeconds(310));
        assertThat(roomba.truth().asleep()).isTrue();
        assertThat(roomba.states()).isEqualTo(SteppedRoomba.at("Asleep", "Asleep"));
        assertThat(readings()).containsEntry("asleep", true);
        assertThat(roomba.roomba.session().isUp()).isTrue();

        roomba.press(RobotEvents.SPOT);

        until("Spot", "Spot", 60);
        assertThat(roomba.truth().activity()).isEqualTo(RobotActivity.SPOT);
    }

    @Test
    void itsOwnButtonWakesItToo() {
        switchOn();
        roomba.advance(Duration.ofSeconds(650));
        assertThat(roomba.truth().asleep()).isTrue();

        roomba.robotPress(Button.CLEAN);
        until("On", "On", 10);

        assertThat(roomba.truth().activity()).isEqualTo(RobotActivity.ON);
        assertThat(roomba.roomba.converter().history())
                .extracting(HistoryEntry::occurrence)
                .as("the press explains everything")
                .noneMatch(Occurrence.Found.class::isInstance);
    }

    @Test
    void askedForItsStateItTakesDockAndTroubleIntoAccount() throws InterruptedException {
        ExecuteCommand asked = new ExecuteCommand(
                roomba.roomba.session(), RoombaPair.of("home").original(), roomba.clock, new Resumption());
        roomba.robot.dock();
        until("Charged", "Charged", 3);
        roomba.advance(Duration.ofSeconds(1));
        assertThat(asked.locate()).contains("Charged");
        roomba.robot.undock();
        until("On", "On", 3);
        roomba.advance(Duration.ofSeconds(3));
        assertThat(asked.locate()).contains("On");
        roomba.robot.lift();
        roomba.advance(Duration.ofSeconds(3));
        assertThat(asked.locate()).contains("Error");
    }

    @Test
    void withLittleChargeItChargesFirstAndThenContinues() {
        roomba.close();
        roomba = at(15);
        switchOn();

        roomba.press(RobotEvents.SPOT);
        until("Dock", "ChargeThenMove", 3);
        roomba.robot.dock();
        until("Charging", "ChargeThenMove", 3);
        roomba.until(() -> !roomba.states().evolved().name().equals("ChargeThenMove"), Duration.ofHours(5));

        until("Spot", "Spot", 120);
        assertThat((Long) readings().get("battery")).isGreaterThan(90);
    }

    @Test
    void aLiftedRobotIsInTroubleUntilItIsSetDown() {
        switchOn();
        roomba.robot.lift();
        until("Error", "Error", 2);
        assertThat(readings()).containsEntry("lifted", true).containsEntry("error", "a wheel hangs in the air");
        assertThat(roomba.roomba.converter().status().troubles())
                .containsExactly(new Trouble(Trouble.DEVICE, "a wheel hangs in the air", 1));

        roomba.robot.setDown();

        until("On", "On", 5);
        roomba.advance(Duration.ofSeconds(3));
        assertThat(roomba.truth().oiMode()).isEqualTo(OiMode.SAFE);
    }

    @Test
    void aRobotWhoseBatteryIsLowGoesHomeByItself() {
        roomba.close();
        roomba = at(11);
        roomba.robot.dock();
        roomba.robot.undock();
        switchOn();
        roomba.press(RobotEvents.CLEAN);

        until("Dock", "Dock", 1_200);

        assertThat(roomba.truth().activity()).isIn(RobotActivity.DOCK, RobotActivity.ON);
        until("Charging", "Charging", 300);
    }

    @Test
    void itsTimetableBeginsToCleanOutsideOfTheQuietHours() {
        switchOn();
        roomba.press(RobotEvents.SCHEDULE);
        until("Clean", "Clean", 2);
        assertThat(roomba.truth().activity()).isEqualTo(RobotActivity.CLEAN);
    }

    @Test
    void fromItsDockAndFromSleepItsTimetableWorksToo() {
        roomba.robot.dock();
        until("Charging", "Charging", 3);
        roomba.press(RobotEvents.SCHEDULE);
        until("Clean", "Clean", 5);
        assertThat(roomba.truth().activity()).isEqualTo(RobotActivity.CLEAN);
    }

    @Test
    void whatTheControllerMayRaiseIsKnown() {
        assertThat(RobotModels.of(RoombaPair.of("home")).buttons())
                .containsExactly("Clean", "Spot", "Dock", "Max", "Power", "Undock", "SpotThenDock");
        assertThat(RobotModels.of(RoombaPair.of("guest")).functions()).isEmpty();
        assertThat(RobotModels.of(RoombaPair.of("paper")).buttons()).isEqualTo(RobotEvents.COMMANDS);
        assertThat(List.copyOf(RobotModels.of(RoombaPair.of("home")).functions().values()))
                .contains(
                        RobotFunction.MOVE, RobotFunction.SPOT_CLEAN, RobotFunction.CHARGE, RobotFunction.QUIET_HOURS);
    }

    @Test
    void aRobotThatIsSwitchedOffStaysOffUntilItIsAskedFor() {
        switchOn();
        roomba.press(RobotEvents.POWER).advance(Duration.ofSeconds(5));
        assertThat(roomba.states()).isEqualTo(SteppedRoomba.at("Off", "Off"));
        assertThat(roomba.truth().activity()).isEqualTo(RobotActivity.OFF);

        switchOn();

        assertThat(roomba.truth().activity()).isEqualTo(RobotActivity.ON);
    }
}
