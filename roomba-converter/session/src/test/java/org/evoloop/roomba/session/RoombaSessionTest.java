package org.evoloop.roomba.session;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.evoloop.roomba.session.Cables.bytes;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import org.evoloop.roomba.oi.ActuatorCommand.DriveDirect;
import org.evoloop.roomba.oi.Button;
import org.evoloop.roomba.oi.Command;
import org.evoloop.roomba.oi.OiMode;
import org.evoloop.roomba.oi.Packet;
import org.evoloop.roomba.oi.SensorValues;
import org.evoloop.roomba.session.connection.RobotConnection;
import org.evoloop.roomba.session.connection.RobotException;
import org.evoloop.roomba.session.inference.ActivityEstimate.EstimatedActivity;
import org.evoloop.roomba.session.inference.SpotWatch;
import org.evoloop.time.ManualClock;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** What a session sends and reports for given frames of its robot. */
class RoombaSessionTest {
    private static final Command SAFE = new Command.Safe();
    private static final Command STOP = new DriveDirect(0, 0);
    private static final SensorValues PASSIVE = Frames.resting(OiMode.PASSIVE);
    private static final SensorValues CONTROLLED = Frames.resting(OiMode.SAFE);
    private static final SensorValues LIFTED = PASSIVE.with(Packet.BUMPS_AND_WHEEL_DROPS, 0b1100);
    private static final SensorValues DOCKED = PASSIVE.with(Packet.CHARGING_SOURCES, 2);

    private final ManualClock clock = new ManualClock();
    private final Cables cables = new Cables();
    private final RoombaSession session = cables.readBy(
            new RoombaSession(cables::plugIn, clock, SessionOptions.defaults().withoutWaiting()));
    private final List<String> notices = new ArrayList<>();

    @BeforeEach
    void open() {
        session.addListener(new SessionListener() {
            @Override
            public void pressed(Button button, boolean robotActs) {
                notices.add(button + (robotActs ? " obeyed" : " reported"));
            }

            @Override
            public void seen(EstimatedActivity activity) {
                notices.add("seen " + activity);
            }
        });
        session.open();
        frames(1, PASSIVE);
        cables.heard();
    }

    @AfterEach
    void close() {
        session.close();
        clock.close();
    }

    /** The robot sends this many frames with these values. */
    private void frames(int count, SensorValues values) {
        cables.show(count, values, clock);
    }

    private void takeControl() {
        session.takeControl();
        frames(2, CONTROLLED);
        assertThat(session.isUnderControl()).isTrue();
        cables.heard();
    }

    /** Nothing arrives from the robot until the session has noticed, and has contacted it again. */
    private void silence() {
        clock.advance(SessionOptions.defaults().silenceLimit().plusMillis(300));
        assertThat(session.isUp()).isFalse();
        cables.heard();
    }

    @Test
    void anUnreachableRobotHasNoReadingsUntilItIsBack() {
        frames(2, CONTROLLED);
        assertThat(session.readings()).isNotEmpty();

        silence();
        assertThat(session.readings()).isEmpty();

        frames(2, CONTROLLED);
        assertThat(session.readings()).isNotEmpty();
    }

    @Test
    void controlIsAskedForOnce() {
        session.takeControl();
        assertThat(cables.heard()).isEqualTo(bytes(SAFE));
        frames(2, CONTROLLED);
        session.takeControl();
        frames(200, CONTROLLED);
        assertThat(cables.heard()).isEmpty();
    }

    @Test
    void controlThatTheRobotGivesUpIsTakenAgainWhenItStandsStill() {
        takeControl();
        frames(300, LIFTED);
        assertThat(cables.heard()).as("in the air it would not obey").isEmpty();
        frames(SpotWatch.QUIET_FRAMES, PASSIVE);
        assertThat(cables.heard()).isEqualTo(bytes(SAFE));
        frames(SpotWatch.QUIET_FRAMES, PASSIVE);
        assertThat(cables.heard())
                .as("it may wait for the rest of some command")
                .hasSizeGreaterThan(500)
                .containsOnly(128);
        frames(SpotWatch.QUIET_FRAMES, PASSIVE);
        assertThat(cables.heard()).isEqualTo(bytes(SAFE));
    }

    @Test
    void oldFramesThatComeAtOnceDoNotMeanThatControlWasNotTaken() {
        session.takeControl();
        cables.heard();
        cables.showAtOnce(2 * SpotWatch.QUIET_FRAMES, PASSIVE);
        frames(2, CONTROLLED);
        assertThat(cables.heard()).isEmpty();
    }

    @Test
    void oldFramesThatComeAtOnceDoNotMeanThatACommandIsLostOrItsWorkHasEnded() {
        session.takeControl();
        session.send(new Command.Clean());
        session.leaveAlone();
        cables.heard();
        cables.showAtOnce(4 * SpotWatch.QUIET_FRAMES, CONTROLLED);
        frames(SpotWatch.QUIET_FRAMES, Frames.cleaning());
        assertThat(notices).containsExactly("seen CLEAN");
        assertThat(cables.heard()).isEmpty();
    }

    @Test
    void oldFramesThatComeAtOnceDoNotHideWhatACommandHasBegun() {
        session.takeControl();
        session.send(new Command.Spot());
        session.leaveAlone();
        cables.heard();
        cables.showAtOnce(2, PASSIVE);
        cables.showAtOnce(2, CONTROLLED);
        frames(SpotWatch.QUIET_FRAMES, Frames.cleaning());
        assertThat(notices).containsExactly("seen SPOT");
        assertThat(cables.heard()).isEmpty();
    }

    @Test
    void aCommandThatIsLostBeforeControlShowsIsRepeated() {
        session.takeControl();
        session.send(new Command.Spot());
        session.leaveAlone();
        cables.heard();
        frames(2, PASSIVE);
        frames(2 * Control.CONFIRM_FRAMES, CONTROLLED);
        assertThat(cables.heard()).endsWith(new Command.Spot().bytes());
    }

    @Test
    void controlIsNotTakenBackFromACommandThatEndsIt() {
        session.takeControl();
        frames(SpotWatch.QUIET_FRAMES - 1, PASSIVE);
        cables.heard();
        session.send(new Command.Clean());
        frames(1, PASSIVE);
        assertThat(cables.heard())
                .as("a Safe would end the cleaning before the session is told to leave the robot alone")
                .isEqualTo(bytes(new Command.Clean()));
    }

    @Test
    @Timeout(60)
    void theAnswerToAPressUnderControlCanBeSentWhileThePressIsStillBeingReported() {
        takeControl();
        session.addListener(new SessionListener() {
            @Override
            public void pressed(Button button, boolean robotActs) {
                CompletableFuture.runAsync(() -> session.send(new Command.Clean()))
                        .join();
            }
        });
        frames(2, CONTROLLED.with(Packet.BUTTONS, 1));
        assertThat(cables.heard()).isEqualTo(bytes(new Command.Clean()));
        assertThat(notices).contains("CLEAN reported");
    }

    @Test
    void aCommandThatEndsControlIsRepeatedUntilItShows() {
        takeControl();
        session.leaveAlone();
        session.send(new Command.Clean());
        assertThat(cables.heard()).isEqualTo(bytes(new Command.Clean()));
        int digesting = 6;
        frames(digesting, CONTROLLED);
        for (int repeated = 0; repeated < 2; repeated++) {
            frames(Control.CONFIRM_FRAMES - digesting, CONTROLLED);
            assertThat(cables.heard())
                    .as("the robot may wait for the rest of some command")
                    .hasSizeGreaterThan(500)
                    .containsOnly(128);
            frames(digesting, CONTROLLED);
            assertThat(cables.heard()).isEqualTo(bytes(new Command.Clean()));
        }
        frames(100, Frames.cleaning());
        assertThat(cables.heard()).isEmpty();
        assertThat(notices).containsExactly("seen CLEAN");
    }

    @Test
    void aPressIsObeyedByTheRobotUnlessItIsUnderControl() {
        frames(3, PASSIVE.with(Packet.BUTTONS, 1));
        assertThat(notices).containsExactly("CLEAN obeyed", "seen ON");
        frames(3, PASSIVE);
        takeControl();
        notices.clear();
        frames(3, CONTROLLED.with(Packet.BUTTONS, 1));
        assertThat(notices).containsExactly("CLEAN reported");
    }

    @Test
    void aRobotThatWasOutOfSightIsStoppedAndObeysAgainOnceThatShows() {
        session.leaveAlone();
        silence();
        frames(4, Frames.cleaning());
        assertThat(cables.heard()).isEqualTo(bytes(SAFE, STOP));
        assertThatThrownBy(() -> session.send(new Command.Spot()))
                .isInstanceOf(RobotException.class)
                .hasMessageContaining("has just reconnected");
        notices.clear();
        frames(2, CONTROLLED);
        assertThat(notices).containsExactly("seen ON");
        session.send(new Command.Spot());
        assertThat(cables.heard()).isEqualTo(bytes(new Command.Spot()));
    }

    @Test
    void aSilentRobotIsSentNothingButWhatStopsIt() {
        takeControl();
        silence();
        assertThatThrownBy(() -> session.send(new Command.Spot()))
                .isInstanceOf(RobotException.class)
                .hasMessageContaining("the robot has fallen silent");
        session.takeControl();
        assertThat(cables.heard()).isEmpty();
        session.release();
        assertThat(cables.heard()).isEqualTo(bytes(STOP, new Command.Start()));
    }

    @Test
    void theEffectOfACommandIsUnknownIfTheCableIsPulledBeforeItShows() throws InterruptedException {
        takeControl();
        session.send(new Command.Clean());
        frames(2, PASSIVE);
        cables.hangUp();
        assertThat(session.awaitEffect()).as("the mode has shown it").isTrue();

        clock.advance(Duration.ofSeconds(1));
        frames(10, CONTROLLED);
        session.send(new Command.Clean());
        cables.hangUp();
        assertThat(session.awaitEffect()).isFalse();
    }

    @Test
    void anActiveRobotIsStoppedOnlyOnceEngaged() {
        session.release();
        silence();
        frames(100, Frames.cleaning());
        assertThat(cables.heard()).isEmpty();
        session.leaveAlone();
        frames(4, Frames.cleaning());
        assertThat(cables.heard()).isEqualTo(bytes(SAFE, STOP));
    }

    @Test
    void lettingGoWhileControlIsRegainedLeavesItToWhoEngagesNext() {
        session.leaveAlone();
        silence();
        frames(4, Frames.cleaning());
        cables.heard();
        session.release();
        assertThat(cables.heard()).isEqualTo(bytes(STOP, new Command.Start()));
        frames(100, Frames.cleaning());
        assertThat(cables.heard()).isEmpty();
        session.leaveAlone();
        frames(4, Frames.cleaning());
        assertThat(cables.heard()).isEqualTo(bytes(SAFE, STOP));
    }

    @Test
    void onEngagingTheEarlierActivityIsReported() {
        frames(3, PASSIVE.with(Packet.BUTTONS, 1));
        frames(100, PASSIVE);
        notices.clear();
        session.leaveAlone();
        frames(SpotWatch.QUIET_FRAMES, PASSIVE);
        assertThat(notices).containsExactly("seen ON");
        frames(300, PASSIVE);
        assertThat(notices).hasSize(1);
    }

    @Test
    void afterACommandTheEarlierActivityIsNotReported() {
        frames(3, PASSIVE.with(Packet.BUTTONS, 1));
        notices.clear();
        session.leaveAlone();
        session.send(new Command.Clean());
        frames(100, PASSIVE);
        assertThat(notices).isEmpty();
    }

    @Test
    void onItsDockTheRobotIsTakenToBeOnAfterSomeTries() {
        session.leaveAlone();
        silence();
        frames(4, DOCKED);
        assertThat(cables.heard()).isEqualTo(bytes(SAFE, STOP));
        frames(5 * SpotWatch.QUIET_FRAMES, DOCKED);
        assertThat(cables.heard()).startsWith(bytes(SAFE)).endsWith(bytes(SAFE));
        assertThat(notices).isEmpty();
        frames(SpotWatch.QUIET_FRAMES, DOCKED);
        assertThat(notices).containsExactly("seen ON");
        session.takeControl();
        frames(6 * SpotWatch.QUIET_FRAMES, DOCKED);
        cables.heard();
        frames(300, DOCKED);
        assertThat(cables.heard()).as("its charging is not disturbed").isEmpty();
    }

    @Test
    void aPressInterruptedByAPulledCableIsNotHalfReceived() {
        session.leaveAlone();
        frames(1, PASSIVE.with(Packet.BUTTONS, 1));
        cables.hangUp();
        clock.advance(RobotConnection.LOOK);
        cables.heard();
        frames(4, PASSIVE);
        assertThat(notices).isEmpty();
        assertThat(cables.heard()).endsWith(bytes(SAFE, STOP));
    }

    @Test
    void closingStopsARobotThatIsOrMayBeUnderControl() {
        session.takeControl();
        cables.heard();
        session.close();
        assertThat(cables.heard()).isEqualTo(bytes(STOP, new Command.Start()));
        session.close();
        assertThat(cables.heard()).isEmpty();
    }

    @Test
    void closingLeavesARobotAloneThatIsOnItsOwn() {
        session.leaveAlone();
        session.close();
        assertThat(cables.heard()).isEmpty();
    }
}
