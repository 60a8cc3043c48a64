package org.evoloop.roomba.session;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.evoloop.roomba.session.Cables.bytes;

import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.evoloop.link.ForwardingLink;
import org.evoloop.link.Link;
import org.evoloop.link.LinkException;
import org.evoloop.link.WakeLine;
import org.evoloop.roomba.oi.ActuatorCommand.DriveDirect;
import org.evoloop.roomba.oi.Button;
import org.evoloop.roomba.oi.Command;
import org.evoloop.roomba.oi.InputCommand;
import org.evoloop.roomba.oi.OiMode;
import org.evoloop.roomba.oi.Packet;
import org.evoloop.roomba.oi.SensorValues;
import org.evoloop.roomba.session.connection.RobotConnection;
import org.evoloop.roomba.session.inference.ActivityEstimate.EstimatedActivity;
import org.evoloop.roomba.session.inference.Circumstances;
import org.evoloop.time.ManualClock;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** An unused robot: it sleeps and is woken, is on its dock and is driven off it. */
class RobotAtRestTest {
    private static final SensorValues PASSIVE = Frames.resting(OiMode.PASSIVE);
    private static final SensorValues CONTROLLED = Frames.resting(OiMode.SAFE);
    private static final SensorValues DOCKED = PASSIVE.with(Packet.CHARGING_SOURCES, 2);
    private static final DriveDirect BACK = new DriveDirect(-100, -100);
    private static final DriveDirect STAND = new DriveDirect(0, 0);
    private static final int FIVE_MINUTES = 5 * 60_000 / 15;

    private final ManualClock clock = new ManualClock();
    private final Cables cables = new Cables();
    private final List<Boolean> wakeLine = new ArrayList<>();
    private final List<String> notices = new ArrayList<>();
    private boolean wired = true;
    private boolean pulledByCommand;
    private final RoombaSession session = cables.readBy(
            new RoombaSession(this::plugIn, clock, SessionOptions.defaults().withoutWaiting()));

    private Link plugIn(int baud) {
        return new ForwardingLink(cables.plugIn(baud)) {
            @Override
            public void send(byte[] bytes) {
                super.send(bytes);
                if (pulledByCommand) {
                    pulledByCommand = false;
                    cables.hangUp();
                }
            }

            @Override
            public WakeLine wakeLine() {
                return low -> wired && wakeLine.add(low);
            }
        };
    }

    @BeforeEach
    void open() {
        session.addListener(new SessionListener() {
            @Override
            public void changed(Circumstances before, Circumstances now, EstimatedActivity activity) {
                notices.add((now.asleep() ? "asleep" : now.docked() ? "docked" : "usual") + ", " + activity);
            }
        });
        session.open();
        frames(1, PASSIVE);
        session.leaveAlone();
        frames(100, PASSIVE);
        cables.heard();
        notices.clear();
    }

    @AfterEach
    void close() {
        session.close();
        clock.close();
    }

    private void frames(int count, SensorValues values) {
        cables.show(count, values, clock);
    }

    private void fallAsleep() {
        session.letSleep(true);
        frames(FIVE_MINUTES, PASSIVE);
        clock.advance(SessionOptions.defaults().silenceLimit().plusMillis(300));
        assertThat(session.isAsleep()).isTrue();
    }

    @Test
    void aRobotThatMaySleepIsNotWoken() {
        fallAsleep();
        clock.advance(Duration.ofHours(8));
        assertThat(wakeLine).isEmpty();
        assertThat(notices).containsExactly("asleep, STANDBY");
        assertThat(session.isUp()).isTrue();
        assertThat(session.downSince()).isEmpty();
        assertThat(session.describe()).contains("asleep; the next event wakes it");
        assertThat(session.readings()).anyMatch(reading -> reading.toString().equals("asleep"));
    }

    @Test
    void aRobotThatMayNotSleepIsKeptAwake() {
        frames(FIVE_MINUTES, PASSIVE);
        assertThat(wakeLine).startsWith(true, false).hasSizeBetween(8, 12);
        clock.advance(SessionOptions.defaults().silenceLimit().plusMillis(300));
        assertThat(session.isAsleep()).isFalse();
        assertThat(session.isUp()).isFalse();
    }

    @Test
    void itIsWokenByItsWakeLineAndTakenUnderControl() throws InterruptedException {
        fallAsleep();
        session.wake();
        clock.advance(RobotConnection.WAKE_PULSE.plus(Duration.ofMillis(100)));
        assertThat(wakeLine).containsExactly(false, true, false);
        assertThat(cables.heard()).isEqualTo(bytes(new Command.Start(), new InputCommand.Stream(RoombaSession.STREAM)));

        frames(10, PASSIVE);

        assertThat(cables.heard()).startsWith(bytes(new Command.Safe(), STAND));
        frames(5, CONTROLLED);
        assertThat(session.isUnderControl()).isTrue();
        assertThat(notices).containsExactly("asleep, STANDBY", "usual, STANDBY");
    }

    @Test
    void withoutAWakeLineItsPortIsOpenedAnew() throws InterruptedException {
        wired = false;
        fallAsleep();
        int plugged = cables.ends().size();
        session.wake();
        assertThat(cables.ends()).hasSize(plugged + 1);
        assertThat(cables.heard()).startsWith(bytes(new Command.Start()));
    }

    @Test
    void aWakingPressIsReported() {
        fallAsleep();
        cables.heard();
        cables.say("key-wakeup\r\n".getBytes(StandardCharsets.US_ASCII));
        assertThat(cables.heard()).startsWith(bytes(new Command.Start()));
        assertThat(session.isAsleep()).isFalse();
    }

    @Test
    void aWakingThatWasNotReceivedIsFound() {
        fallAsleep();
        cables.heard();
        clock.advance(RobotConnection.ASK_SLEEPER.plus(Duration.ofMillis(300)));
        assertThat(cables.heard()).isEqualTo(bytes(new Command.Start(), new InputCommand.Stream(RoombaSession.STREAM)));
        frames(20, PASSIVE);
        assertThat(session.isAsleep()).isFalse();
        assertThat(notices).containsExactly("asleep, STANDBY", "usual, STANDBY");
    }

    @Test
    void unusedItIsReleased() {
        session.takeControl();
        frames(3, CONTROLLED);
        cables.heard();
        session.rest();
        assertThat(cables.heard()).isEqualTo(bytes(new Command.Start()));
        frames(200, PASSIVE);
        assertThat(cables.heard()).as("control is not taken back").isEmpty();
    }

    @Test
    void itLeavesItsDockInFullModeAndContinuesInSafe() throws InterruptedException {
        SensorValues full = Frames.resting(OiMode.FULL).with(Packet.CHARGING_SOURCES, 2);
        frames(5, DOCKED);
        session.leaveDock();
        assertThat(cables.heard()).isEqualTo(bytes(new Command.Full()));
        frames(2, full);
        assertThat(cables.heard()).isEqualTo(bytes(BACK));
        assertThat(session.isUndocking()).isTrue();

        frames(1, Frames.resting(OiMode.FULL));
        assertThat(cables.heard()).isEqualTo(bytes(new Command.Safe()));
        frames(2, CONTROLLED);
        assertThat(cables.heard()).isEqualTo(bytes(BACK));

        frames(1, CONTROLLED.with(Packet.LEFT_ENCODER, -700).with(Packet.RIGHT_ENCODER, -700));
        assertThat(cables.heard()).isEqualTo(bytes(STAND));
        assertThat(session.isUndocking()).isFalse();
    }

    @Test
    void movingItOnItsWayOffTheDockTakesPrecedence() throws InterruptedException {
        frames(5, DOCKED);
        session.leaveDock();
        session.release();
        assertThat(session.isUndocking()).isFalse();
        cables.heard();
        frames(100, DOCKED);
        assertThat(cables.heard()).isEmpty();

        session.leaveAlone();
        session.leaveDock();
        frames(4, DOCKED.with(Packet.BUTTONS, Button.toBits(Set.of(Button.CLEAN))));
        frames(4, DOCKED);
        assertThat(session.isUndocking()).isFalse();
        cables.heard();
        frames(100, DOCKED);
        assertThat(cables.heard()).isEmpty();
    }

    @Test
    void aRobotOutOfReachIsNotDrivenOffItsDock() {
        frames(5, DOCKED);
        cables.hangUp();
        clock.advance(Duration.ofMillis(10));
        assertThatThrownBy(session::leaveDock).isInstanceOf(LinkException.class);
        assertThat(session.isUndocking()).isFalse();
    }

    @Test
    void aRobotWhoseCableIsPulledAsItIsToLeaveItsDockDoesNotStartWhenItIsBack() throws InterruptedException {
        frames(5, DOCKED);
        pulledByCommand = true;
        assertThat(session.leaveDock()).as("it is known what the robot did").isFalse();
        clock.advance(Duration.ofSeconds(1));
        cables.heard();
        frames(100, DOCKED);
        assertThat(session.isUndocking()).isFalse();
        assertThat(cables.heard()).isEqualTo(bytes(new Command.Safe(), STAND, new Command.Safe()));
    }

    @Test
    void aRobotThatStaysOnItsDockIsLeftThere() throws InterruptedException {
        frames(5, DOCKED);
        session.leaveDock();
        frames(200, DOCKED);
        assertThat(session.isUndocking()).isFalse();
        assertThat(cables.heard()).endsWith(bytes(STAND, new Command.Start()));
        notices.clear();
        frames(1, DOCKED);
        assertThat(notices).as("reported, in case a listener assumes otherwise").containsExactly("docked, ON");
    }
}
