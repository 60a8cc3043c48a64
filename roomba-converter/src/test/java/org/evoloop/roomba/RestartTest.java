package org.evoloop.roomba;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import org.awaitility.Awaitility;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/**
 * A converter with a journal is killed, the robot's own buttons are used, and another process continues: its recorded
 * state is where the robot is, not where it was. All are separate processes.
 */
@Timeout(value = 240, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
@EnabledOnOs(OS.LINUX)
class RestartTest {
    private int lives;
    private OtherRobot robot;

    @TempDir
    private Path folder;

    @BeforeEach
    void startTheRobot() throws IOException {
        robot = new OtherRobot();
    }

    @AfterEach
    void leaveNoProcess() {
        robot.close();
    }

    private Path log() {
        return folder.resolve("log" + lives);
    }

    private Process start() throws IOException {
        lives++;
        return robot.convert(log(), "--journal", folder.resolve("journal").toString());
    }

    private void awaitActivity(String activity) {
        robot.await(activity, now -> now.activity().equals(activity));
    }

    /** Polls until the converter reports these states. */
    private void awaitStates(Process converter, String states) {
        Awaitility.await(states)
                .atMost(Duration.ofSeconds(60))
                .pollInterval(Duration.ofMillis(200))
                .until(() -> {
                    OtherRobot.type(converter, "status\n");
                    return Files.readString(log()).contains("states      " + states);
                });
    }

    private void killed(Process converter) throws InterruptedException {
        converter.destroyForcibly().waitFor();
        robot.await("the guard has done its work", OtherRobot.Truth::isPassive);
    }

    @Test
    void aRobotThatWasPausedByItsButtonIsOn() throws Exception {
        Process first = start();
        OtherRobot.type(first, "press clean\npress clean\n");
        awaitActivity("clean");
        awaitStates(first, "original Clean, new Clean");
        killed(first);
        robot.execute("press clean");
        awaitActivity("on");

        awaitStates(start(), "original On, new On");
    }

    @Test
    void aRobotThatStillCleansIsLeftAlone() throws Exception {
        Process first = start();
        OtherRobot.type(first, "press clean\npress clean\n");
        awaitActivity("clean");
        awaitStates(first, "original Clean, new Clean");
        killed(first);

        Process second = start();
        awaitStates(second, "original Clean, new Clean");
        long begun = robot.truth().millis();
        robot.await("as long as it takes to be found", now -> now.millis() - begun > 5_000);
        assertThat(robot.truth().activity()).isEqualTo("clean");
        assertThat(Files.readString(log())).doesNotContain("found On");
    }

    @Test
    void aRobotThatWasSwitchedOnAndCleansIsFoundCleaning() throws Exception {
        Process first = start();
        awaitStates(first, "original Off, new Off");
        killed(first);
        robot.execute("press clean");
        awaitActivity("on");
        robot.await("the button is up", now -> !robot.execute("state").contains("\"pressed\":[\""));
        robot.execute("press clean");
        awaitActivity("clean");

        awaitStates(start(), "original Clean, new Clean");
        assertThat(robot.truth().activity()).as(Files.readString(log())).isEqualTo("clean");
    }

    @Test
    void aRobotThatWasOnIsTakenUnderControlAgain() throws Exception {
        Process first = start();
        OtherRobot.type(first, "press clean\n");
        robot.await("control", now -> now.mode().equals("safe"));
        awaitStates(first, "original On, new On");
        killed(first);
        robot.execute("press clean");
        awaitActivity("clean");

        Process second = start();
        robot.await("control", now -> now.mode().equals("safe") && !now.drives());
        awaitStates(second, "original On, new On");
        assertThat(robot.truth().activity()).isEqualTo("on");
    }
}
