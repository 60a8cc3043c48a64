package org.evoloop.roomba.testkit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.time.Duration;
import java.util.HashSet;
import java.util.Set;
import org.evoloop.link.Link;
import org.evoloop.link.SerialLink;
import org.evoloop.link.SerialSettings;
import org.evoloop.roomba.oi.ActuatorCommand.DriveDirect;
import org.evoloop.roomba.oi.Button;
import org.evoloop.roomba.oi.Command;
import org.evoloop.roomba.oi.OiMode;
import org.evoloop.roomba.simulator.robot.RobotActivity;
import org.evoloop.roomba.simulator.robot.RobotState;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.extension.RegisterExtension;

/** A test of another program: it has a robot at a port, and leaves nothing behind. */
@EnabledOnOs(OS.LINUX)
@Timeout(60)
class SimulatedRoombaExtensionTest {
    private static final Set<Path> PORTS = new HashSet<>();

    @RegisterExtension
    final SimulatedRoombaExtension roomba =
            SimulatedRoombaExtension.create().speed(10).patience(Duration.ofSeconds(30));

    @BeforeEach
    void note() {
        assertThat(PORTS.add(roomba.port()))
                .as("each test has a port of its own")
                .isTrue();
    }

    @AfterAll
    static void nothingIsLeftBehind() {
        assertThat(PORTS).noneMatch(port -> Files.exists(port, LinkOption.NOFOLLOW_LINKS));
        assertThat(PORTS).noneMatch(port -> Files.exists(port.resolveSibling("")));
    }

    @Test
    void aProgramDrivesItThroughItsPort() throws Exception {
        try (Link link = SerialLink.open(new SerialSettings(roomba.port().toString()))) {
            link.send(new Command.Start().bytes());
            link.send(new Command.Safe().bytes());
            link.send(new DriveDirect(100, 100).bytes());
            RobotState there = roomba.until(robot -> robot.xMm() > 50);
            assertThat(there.oiMode()).isEqualTo(OiMode.SAFE);
        }
    }

    @Test
    void itsButtonsArePressed() throws Exception {
        assertThat(roomba.state().activity()).isEqualTo(RobotActivity.OFF);
        roomba.press(Button.CLEAN);
        roomba.until(robot -> robot.activity() != RobotActivity.OFF);
        roomba.robot().lift();
    }

    @Test
    void itsCableIsPulledAndPluggedIn() throws Exception {
        roomba.unplug();
        assertThat(Files.exists(roomba.port(), LinkOption.NOFOLLOW_LINKS)).isFalse();
        roomba.replug();
        assertThat(roomba.port()).exists();
    }

    @Test
    void aConditionThatNeverHoldsIsReportedWithTheRobotsState() throws Exception {
        // The first state comes with the robot's first tick.
        roomba.until(robot -> true);
        roomba.patience(Duration.ofMillis(50));
        assertThatThrownBy(() -> roomba.until(robot -> robot.xMm() > 1e9))
                .isInstanceOf(AssertionError.class)
                .hasMessageContaining("did not reach the wanted state within PT0.05S; it is {");
    }

    @Test
    void outsideOfATestThereIsNoRobot() {
        assertThatThrownBy(() -> SimulatedRoombaExtension.create().port())
                .isInstanceOf(IllegalStateException.class)
                .hasMessageContaining("@RegisterExtension");
    }
}
