package org.evoloop.roomba.session;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Random;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import org.evoloop.link.LinkException;
import org.evoloop.link.LinkException.Fault;
import org.evoloop.link.SerialLink;
import org.evoloop.link.SerialSettings;
import org.evoloop.natives.Pty;
import org.evoloop.roomba.oi.ActuatorCommand.DriveDirect;
import org.evoloop.roomba.oi.Command;
import org.evoloop.roomba.oi.OiMode;
import org.evoloop.roomba.oi.StreamFrame;
import org.evoloop.roomba.session.connection.RobotException;
import org.evoloop.roomba.simulator.SimulatorServer;
import org.evoloop.roomba.simulator.robot.RobotOptions;
import org.evoloop.time.Clock;
import org.evoloop.time.SystemClock;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/**
 * Sessions at real serial ports: what is reported about different devices at the other end, and which faults are
 * survived.
 */
@EnabledOnOs(OS.LINUX)
@Timeout(60)
class DiagnosisTest {
    /** With limits long enough in real time that a slow computer does not look like a silent robot. */
    private static final SessionOptions PATIENT = SessionOptions.defaults().withSilenceLimit(Duration.ofSeconds(20));

    private final Clock clock = new SystemClock(20);

    @TempDir
    Path folder;

    @AfterEach
    void closeClock() {
        clock.close();
    }

    private Path port() {
        return folder.resolve("roomba");
    }

    private SimulatorServer robot(RobotOptions.Builder options) throws IOException {
        return SimulatorServer.start(port(), options.build(), clock, 1);
    }

    private RoombaSession session(SessionOptions options) {
        return new RoombaSession(
                baud -> SerialLink.open(new SerialSettings(port().toString()).withBaud(baud)), clock, options);
    }

    /** Opens a session at a port where something sends this repeatedly and reads nothing. */
    private String diagnosisOf(byte[] saying) throws Exception {
        try (Pty pty = Pty.open(port());
                RoombaSession session = session(SessionOptions.defaults())) {
            CompletableFuture<Void> talk = CompletableFuture.runAsync(() -> {
                byte[] buffer = new byte[1_024];
                while (!pty.isHungUp()) {
                    pty.read(buffer, 10);
                    pty.write(saying, saying.length);
                }
            });
            session.open();
            try {
                session.awaitRobot();
                throw new AssertionError("took it for a robot");
            } catch (RobotException diagnosis) {
                return String.valueOf(diagnosis.getMessage());
            } finally {
                pty.hangUp();
                talk.get(10, TimeUnit.SECONDS);
            }
        }
    }

    @Test
    void aPortWithoutAnAnswerIsNamedWithARemedy() throws Exception {
        assertThat(diagnosisOf(new byte[0]))
                .startsWith("serial port " + port())
                .contains("no answer at 115200 nor 19200 baud", "asleep or off", "Press CLEAN");
    }

    @Test
    void somethingElseThatTalksIsQuoted() throws Exception {
        assertThat(diagnosisOf("Marlin 1.1.9\r\nstart\r\n".getBytes(StandardCharsets.US_ASCII)))
                .startsWith("serial port " + port())
                .contains("this is not a Roomba, it says 'Marlin 1.1.9 start", "choose the port");
    }

    @Test
    void garbageIsTakenForAnotherRate() throws Exception {
        byte[] garbage = new byte[50];
        new Random(42).nextBytes(garbage);
        assertThat(diagnosisOf(garbage)).contains("bytes come, but no frames", "another baud rate");
    }

    @Test
    void aChecksumOfAnotherConventionIsNamedAndNotTakenForAnotherRate() throws Exception {
        byte[] frame = StreamFrame.encode(RoombaSession.STREAM, packet -> 1, StreamFrame.Checksum.WITHOUT_HEADER);
        assertThat(diagnosisOf(frame))
                .contains("checksum leaves out the header byte", "--checksum spec500")
                .doesNotContain("another baud rate");
    }

    @Test
    void aChecksumThatNeverFitsIsNamed() throws Exception {
        byte[] frame = StreamFrame.encode(RoombaSession.STREAM, packet -> 1);
        frame[frame.length - 1]++;
        assertThat(diagnosisOf(frame)).contains("checksum never fits").doesNotContain("another baud rate");
    }

    @Test
    void aPortThatDoesNotExistIsReportedAtOnce() {
        try (RoombaSession session = session(PATIENT)) {
            assertThatThrownBy(session::open)
                    .isInstanceOfSatisfying(
                            LinkException.class,
                            missing -> assertThat(missing.fault()).isEqualTo(Fault.NO_SUCH_PORT))
                    .hasMessageContaining(port().toString());
        }
    }

    @Test
    void aPortThatIsInUseIsReportedAtOnce() throws IOException {
        try (SimulatorServer robot = robot(RobotOptions.builder());
                RoombaSession first = session(PATIENT);
                RoombaSession second = session(PATIENT)) {
            first.open();
            assertThatThrownBy(second::open)
                    .isInstanceOfSatisfying(
                            LinkException.class,
                            busy -> assertThat(busy.fault()).isEqualTo(Fault.BUSY))
                    .hasMessageContaining(robot.path().toString());
        }
    }

    @Test
    void aRobotAtTheAlternateRateIsBroughtToTheUsualOne() throws Exception {
        try (SimulatorServer robot = robot(RobotOptions.builder().baud(19_200));
                RoombaSession session = session(PATIENT)) {
            session.open();
            session.awaitRobot();
            assertThat(robot.robot().baud()).isEqualTo(115_200);
            assertThat(session.describe()).contains("at 115200 baud", "mode passive");
        }
    }

    @Test
    void aModeThatIsReportedTooHighIsReadRight() throws Exception {
        try (SimulatorServer robot = robot(RobotOptions.builder().modeOffset(1))) {
            assertThat(robot.robot().state().oiMode()).isEqualTo(OiMode.OFF);
            for (SessionOptions options : List.of(PATIENT, PATIENT.withModeOffset(1))) {
                try (RoombaSession session = session(options)) {
                    session.open();
                    session.awaitRobot();
                    await().untilAsserted(() -> assertThat(session.describe()).contains("mode passive"));
                    session.takeControl();
                    await().until(session::isUnderControl);
                    assertThat(robot.robot().state().oiMode()).isEqualTo(OiMode.SAFE);
                }
            }
        }
    }

    @Test
    void aRobotThatNeedsTimeAfterAModeChangeIsBroughtUnderControl() throws Exception {
        try (SimulatorServer robot = robot(RobotOptions.builder().strictModeWindow(true));
                RoombaSession session = session(PATIENT)) {
            session.open();
            session.awaitRobot();
            session.takeControl();
            await().until(session::isUnderControl);
            session.send(new DriveDirect(100, 100));
            await().until(() -> robot.robot().state().leftMmPerS() > 50);
        }
    }

    @Test
    void aNoisyLineIsTolerated() throws Exception {
        RobotOptions.Builder noisy =
                RobotOptions.builder().noise(true).dropShare(0.002).corruptShare(0.002);
        try (SimulatorServer robot = robot(noisy);
                RoombaSession session = session(PATIENT)) {
            session.open();
            session.awaitRobot();
            session.takeControl();
            await().until(session::isUnderControl);
            assertThat(robot.robot().state().oiMode()).isEqualTo(OiMode.SAFE);
        }
    }

    @Test
    void aRobotThatFallsSilentIsFoundAgain() throws Exception {
        try (SimulatorServer robot = robot(RobotOptions.builder());
                RoombaSession session = session(PATIENT)) {
            session.open();
            session.awaitRobot();
            session.takeControl();
            await().until(session::isUnderControl);
            session.send(new Command.Stop());
            await().until(() -> robot.robot().state().oiMode() == OiMode.OFF);
            await("control is taken again").until(() -> robot.robot().state().oiMode() == OiMode.SAFE);
            assertThat(session.isUp()).isTrue();
        }
    }

    @Test
    void aListenerThatFailsDoesNotEndTheReading() throws Exception {
        CountDownLatch failures = new CountDownLatch(3);
        try (SimulatorServer robot = robot(RobotOptions.builder());
                RoombaSession session = session(PATIENT)) {
            session.addListener(new SessionListener() {
                @Override
                public void received(Telemetry telemetry) {
                    failures.countDown();
                    throw new IllegalStateException("a listener's bug, thrown on purpose");
                }
            });
            session.open();
            assertThat(failures.await(10, TimeUnit.SECONDS)).isTrue();
            session.awaitRobot();
            assertThat(robot.robot().state().oiMode()).isEqualTo(OiMode.PASSIVE);
        }
    }

    @Test
    void closingRightAfterControlWasTakenLeavesTheRobotPassive() throws Exception {
        try (SimulatorServer robot = robot(RobotOptions.builder())) {
            try (RoombaSession session = session(PATIENT)) {
                session.open();
                session.awaitRobot();
                session.takeControl();
            }
            await().until(() -> robot.robot().state().oiMode() == OiMode.PASSIVE);
        }
    }

    @Test
    void waitingCanBeInterruptedAndEndedByClosing() throws Exception {
        try (Pty nobody = Pty.open(port());
                RoombaSession session = session(PATIENT)) {
            assertThat(nobody.isHungUp()).isFalse();
            session.open();
            Thread.currentThread().interrupt();
            assertThatThrownBy(session::awaitRobot).isInstanceOf(InterruptedException.class);

            CompletableFuture<Void> waiting = CompletableFuture.runAsync(() -> {
                try {
                    session.awaitRobot();
                } catch (InterruptedException stop) {
                    throw new IllegalStateException(stop);
                }
            });
            session.close();
            assertThatThrownBy(() -> waiting.get(10, TimeUnit.SECONDS))
                    .isInstanceOf(ExecutionException.class)
                    .cause()
                    .isInstanceOf(LinkException.class)
                    .hasMessageContaining("closed before the robot answered");
        }
    }
}
