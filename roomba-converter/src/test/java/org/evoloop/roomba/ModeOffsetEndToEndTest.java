package org.evoloop.roomba;

import static org.assertj.core.api.Assertions.assertThat;
import static org.evoloop.roomba.SteppedRoomba.at;

import java.time.Duration;
import org.evoloop.roomba.oi.Button;
import org.evoloop.roomba.oi.OiMode;
import org.evoloop.roomba.session.SessionOptions;
import org.evoloop.roomba.simulator.robot.RobotActivity;
import org.evoloop.roomba.simulator.robot.RobotOptions;
import org.junit.jupiter.api.Test;

/** A robot that reports its mode one too high, and a converter without the option for that. */
class ModeOffsetEndToEndTest {
    private static final Duration LONG = Duration.ofSeconds(12);

    private static SteppedRoomba robot(SessionOptions session) {
        return new SteppedRoomba(RobotOptions.builder().modeOffset(1).build(), session);
    }

    private static void startCleaning(SteppedRoomba roomba) {
        roomba.advance(Duration.ofSeconds(1)).press(RobotEvents.CLEAN).advance(Duration.ofSeconds(1));
        assertThat(roomba.truth().oiMode()).isEqualTo(OiMode.SAFE);
        roomba.press(RobotEvents.CLEAN);
    }

    private static void assertCleansOn(SteppedRoomba roomba) {
        for (long passed = 0; passed < LONG.toMillis(); passed += 300) {
            roomba.advance(Duration.ofMillis(300));
            assertThat(roomba.truth().activity()).isEqualTo(RobotActivity.CLEAN);
        }
    }

    @Test
    void itIsDetectedAndReportedAndEverythingWorks() {
        try (SteppedRoomba roomba = robot(SessionOptions.defaults())) {
            startCleaning(roomba);
            assertCleansOn(roomba);
            assertThat(roomba.states()).isEqualTo(at("Clean", "Clean"));
            assertThat(roomba.roomba.session().describe()).contains("mode passive (reported one too high)");
            roomba.robotPress(Button.CLEAN).advance(Duration.ofSeconds(1));
            assertThat(roomba.states()).isEqualTo(at("On", "SpotWait"));
        }
    }

    @Test
    void withAWrongModeOffsetTheRobotIsStillNotToggled() {
        try (SteppedRoomba roomba = robot(SessionOptions.defaults().withModeOffset(0))) {
            roomba.advance(Duration.ofSeconds(2));
            assertThat(roomba.states()).as("it seems to be under control").isEqualTo(at("On", "On"));
            roomba.press(RobotEvents.CLEAN);
            assertCleansOn(roomba);
        }
    }

    @Test
    void aRobotThatWasLeftInSafeModeByAnotherProgramIsNotMistaken() {
        try (SteppedRoomba roomba = new SteppedRoomba(RobotOptions.defaults())) {
            roomba.press(RobotEvents.CLEAN).advance(Duration.ofSeconds(1));
            assertThat(roomba.truth().oiMode()).isEqualTo(OiMode.SAFE);
            roomba.unplug();
            roomba.advance(Duration.ofSeconds(1)).replug();
            roomba.advance(Duration.ofSeconds(3));
            assertThat(roomba.truth().oiMode()).isEqualTo(OiMode.SAFE);
            assertThat(roomba.roomba.session().describe()).contains("mode safe,");
        }
    }
}
