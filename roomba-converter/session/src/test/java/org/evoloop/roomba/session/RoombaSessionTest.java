package org.evoloop.roomba.session;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.evoloop.roomba.session.Cables.bytes;

import java.util.ArrayList;
import java.util.List;
import org.evoloop.roomba.oi.ActuatorCommand.DriveDirect;
import org.evoloop.roomba.oi.Button;
import org.evoloop.roomba.oi.Command;
import org.evoloop.roomba.oi.OiMode;
import org.evoloop.roomba.oi.Packet;
import org.evoloop.roomba.oi.SensorValues;
import org.evoloop.roomba.session.connection.Connection;
import org.evoloop.roomba.session.connection.RobotException;
import org.evoloop.roomba.session.inference.ActivityEstimate.EstimatedActivity;
import org.evoloop.roomba.session.inference.SpotWatch;
import org.evoloop.time.ManualClock;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** What a session sends to its robot and tells of it, for what the robot shows. */
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
    private final List<String> told = new ArrayList<>();

    @BeforeEach
    void open() {
        session.addListener(new SessionListener() {
            @Override
            public void pressed(Button button, boolean robotActs) {
                told.add(button + (robotActs ? " obeyed" : " reported"));
            }

            @Override
            public void seen(EstimatedActivity activity) {
                told.add("seen " + activity);
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

    /** The robot shows this so many times. */
    private void frames(int count, SensorValues values) {
        cables.show(count, values, clock);
    }

    private void takeControl() {
        session.takeControl();
        frames(2, CONTROLLED);
        assertThat(session.isUnderControl()).isTrue();
        cables.heard();
    }

    /** Nothing comes from the robot until that is noticed, and then until it has been asked. */
    private void silence() {
        clock.advance(SessionOptions.defaults().silenceLimit().plusMillis(300));
        assertThat(session.isUp()).isFalse();
        cables.heard();
    }

    @Test
    void ofARobotOutOfReachNothingIsToldUntilItIsBack() {
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
    void controlThatTheRobotGivesUpIsTakenAgainWhenItStands() {
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
        assertThat(told).containsExactly("seen CLEAN");
    }

    @Test
    void aPressIsObeyedByTheRobotUnlessItIsUnderControl() {
        frames(3, PASSIVE.with(Packet.BUTTONS, 1));
        assertThat(told).containsExactly("CLEAN obeyed", "seen ON");
        frames(3, PASSIVE);
        takeControl();
        told.clear();
        frames(3, CONTROLLED.with(Packet.BUTTONS, 1));
        assertThat(told).containsExactly("CLEAN reported");
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
        told.clear();
        frames(2, CONTROLLED);
        assertThat(told).containsExactly("seen ON");
        session.send(new Command.Spot());
        assertThat(cables.heard()).isEqualTo(bytes(new Command.Spot()));
    }

    @Test
    void aRobotThatNobodyIsEngagedWithIsStoppedOnlyWhenSomebodyIs() {
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
    void whoeverEngagesIsToldWhatHappenedBefore() {
        frames(3, PASSIVE.with(Packet.BUTTONS, 1));
        frames(100, PASSIVE);
        told.clear();
        session.leaveAlone();
        frames(SpotWatch.QUIET_FRAMES, PASSIVE);
        assertThat(told).containsExactly("seen ON");
        frames(300, PASSIVE);
        assertThat(told).hasSize(1);
    }

    @Test
    void whoeverCommandsIsNotToldWhatWasBefore() {
        frames(3, PASSIVE.with(Packet.BUTTONS, 1));
        told.clear();
        session.leaveAlone();
        session.send(new Command.Clean());
        frames(100, PASSIVE);
        assertThat(told).isEmpty();
    }

    @Test
    void onItsDockTheRobotIsTakenToBeOnAfterSomeTries() {
        session.leaveAlone();
        silence();
        frames(4, DOCKED);
        assertThat(cables.heard()).isEqualTo(bytes(SAFE, STOP));
        frames(5 * SpotWatch.QUIET_FRAMES, DOCKED);
        assertThat(cables.heard()).startsWith(bytes(SAFE)).endsWith(bytes(SAFE));
        assertThat(told).isEmpty();
        frames(SpotWatch.QUIET_FRAMES, DOCKED);
        assertThat(told).containsExactly("seen ON");
        session.takeControl();
        frames(6 * SpotWatch.QUIET_FRAMES, DOCKED);
        cables.heard();
        frames(300, DOCKED);
        assertThat(cables.heard()).as("it charges in peace").isEmpty();
    }

    @Test
    void aPressThatTheCableWasPulledInIsNotHalfHeard() {
        session.leaveAlone();
        frames(1, PASSIVE.with(Packet.BUTTONS, 1));
        cables.hangUp();
        clock.advance(Connection.LOOK);
        cables.heard();
        frames(4, PASSIVE);
        assertThat(told).isEmpty();
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
