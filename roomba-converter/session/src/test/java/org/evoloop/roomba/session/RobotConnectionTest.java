package org.evoloop.roomba.session;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.time.Duration;
import java.time.Instant;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.IntFunction;
import org.evoloop.link.ForwardingLink;
import org.evoloop.link.Link;
import org.evoloop.link.LinkException;
import org.evoloop.link.LinkException.Fault;
import org.evoloop.link.MemoryLink;
import org.evoloop.roomba.oi.ActuatorCommand;
import org.evoloop.roomba.oi.Command;
import org.evoloop.roomba.oi.InputCommand;
import org.evoloop.roomba.oi.OiMode;
import org.evoloop.roomba.oi.StreamFrame;
import org.evoloop.roomba.session.connection.RobotConnection;
import org.evoloop.roomba.session.connection.RobotException;
import org.evoloop.time.Clock;
import org.evoloop.time.ManualClock;
import org.evoloop.time.SystemClock;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** The connection step by step, on a cable in memory whose other end sends only what a test makes it send. */
@Timeout(30)
class RobotConnectionTest {
    private static final byte[] FRAME = StreamFrame.encode(RoombaSession.STREAM, packet -> 0);
    private static final Duration LONG = Duration.ofSeconds(30);

    private final ManualClock clock = new ManualClock();
    private final Cables cables = new Cables();

    private RoombaSession session(IntFunction<Link> cable) {
        return cables.readBy(
                new RoombaSession(cable, clock, SessionOptions.defaults().withoutWaiting()));
    }

    @Test
    void aRobotThatAnswersWhileItIsWokenIsNotDisturbedAnyMore() {
        try (RoombaSession session = session(cables::plugIn)) {
            session.open();
            clock.advance(RobotConnection.ANSWER_LIMIT.plusMillis(100));
            cables.heard();
            cables.say(FRAME);
            clock.advance(RobotConnection.WAKE_PULSE.plusMillis(300));
            assertThat(session.isUp()).isTrue();
            assertThat(cables.heard())
                    .as("a Start would end the control taken meanwhile")
                    .isEmpty();
        }
    }

    @Test
    void whatIsTriedIsReportedWithinSecondsOnce() {
        try (RoombaSession session = session(cables::plugIn)) {
            session.open();
            clock.advance(Duration.ofSeconds(2));
            assertThat(session.describe())
                    .contains("no answer yet", "woken by its wake line", "19200 baud", "press CLEAN");
            while (!session.isUp()) {
                cables.say(FRAME);
                clock.advance(Duration.ofMillis(250));
            }
            assertThat(session.downSince()).isEmpty();
            Instant lastHeard = clock.wallTime().minusMillis(250);
            clock.advance(Duration.ofMillis(1_750));
            assertThat(session.describe()).contains("fallen silent", "woken by its wake line");
            assertThat(session.downSince()).contains(lastHeard);
            clock.advance(Duration.ofSeconds(2));
            assertThat(session.describe()).contains("fallen silent");
        }
    }

    @Test
    void aSilentRobotIsSentTheUsualRateAtItsAlternateOne() {
        try (RoombaSession session = session(cables::plugIn)) {
            session.open();
            while (cables.bauds.size() < 2) {
                cables.heard();
                clock.advance(Duration.ofMillis(10));
            }
            cables.say(FRAME);
            assertThat(session.isUp())
                    .as("a frame at the rate that is about to end does not count")
                    .isFalse();
            while (cables.bauds.size() < 3) {
                clock.advance(Duration.ofMillis(10));
            }
            assertThat(cables.bauds).containsExactly(115_200, 19_200, 115_200);
            byte[] heard = cables.heard();
            byte[] rate = new Command.Baud(115_200).bytes();
            assertThat(heard).containsSubsequence(rate[0], rate[1]);
            assertThat(heard)
                    .as("a possibly incomplete command is completed first")
                    .startsWith(new byte[] {(byte) 128, (byte) 128});
            cables.say(FRAME);
            assertThat(session.isUp()).isTrue();
        }
    }

    @Test
    void aRobotThatNeverAnswersIsDiagnosedAndStillWaitedFor() {
        try (RoombaSession session = session(cables::plugIn)) {
            session.open();
            clock.advance(LONG);
            assertThatThrownBy(session::awaitRobot)
                    .isInstanceOf(RobotException.class)
                    .hasMessageContaining("no answer at 115200 nor 19200 baud")
                    .hasMessageContaining("Press CLEAN");
            while (cables.bauds.get(cables.bauds.size() - 1) != 115_200) {
                clock.advance(RobotConnection.LOOK);
            }
            cables.say(FRAME);
            assertThat(session.isUp()).isTrue();
        }
    }

    @Test
    void aRobotThatIsNotThereYetIsWaitedForAndGreeted() throws InterruptedException {
        AtomicBoolean there = new AtomicBoolean();
        Command greeting = new Command.Schedule(Map.of());
        try (RoombaSession session = session(baud -> {
            if (!there.get()) {
                throw new LinkException(Fault.NO_SUCH_PORT, "serial port /dev/x does not exist; plug it in");
            }
            return cables.plugIn(baud);
        })) {
            session.openPatiently(List.of(greeting));
            clock.advance(LONG);
            assertThat(session.describe()).isEqualTo("serial port /dev/x does not exist; plug it in");
            there.set(true);
            clock.advance(LONG);
            assertThat(session.describe()).as("it sleeps").contains("no answer yet");
            while (cables.bauds.get(cables.bauds.size() - 1) != 115_200) {
                clock.advance(RobotConnection.LOOK);
            }
            cables.heard();
            cables.say(FRAME);
            assertThat(session.isUp()).isTrue();
            assertThat(cables.heard()).containsSequence(greeting.bytes());
        }
    }

    @Test
    void aCableThatIsPulledBeforeTheRobotAnswersEndsTheWait() {
        try (RoombaSession session = session(cables::plugIn)) {
            session.open();
            cables.hangUp();
            assertThatThrownBy(session::awaitRobot)
                    .isInstanceOfSatisfying(
                            LinkException.class,
                            lost -> assertThat(lost.fault()).isEqualTo(Fault.HUNG_UP));
        }
    }

    @Test
    void aRobotThatFallsSilentIsAskedAgain() {
        try (RoombaSession session = session(cables::plugIn)) {
            session.open();
            cables.say(FRAME);
            assertThat(session.isUp()).isTrue();
            cables.heard();
            clock.advance(SessionOptions.defaults()
                    .silenceLimit()
                    .plus(RobotConnection.LOOK)
                    .plus(RobotConnection.MODE_CHANGE));
            assertThat(session.isUp()).isFalse();
            assertThat(session.describe()).contains("fallen silent");
            ByteArrayOutputStream question = new ByteArrayOutputStream();
            question.writeBytes(new Command.Start().bytes());
            question.writeBytes(new InputCommand.Stream(RoombaSession.STREAM).bytes());
            assertThat(cables.heard()).isEqualTo(question.toByteArray());
            cables.say(FRAME);
            assertThat(session.isUp()).isTrue();
        }
    }

    @Test
    void twoReplugsInARowEndInOneLink() {
        try (RoombaSession session = session(cables::plugIn)) {
            session.open();
            cables.say(FRAME);
            cables.hangUp();
            clock.advance(RobotConnection.LOOK);
            cables.hangUp();
            assertThat(session.isUp()).isFalse();
            clock.advance(RobotConnection.LOOK);
            cables.say(FRAME);
            assertThat(session.isUp()).isTrue();
            assertThat(cables.bauds).containsExactly(115_200, 115_200, 115_200);
            clock.advance(Duration.ofSeconds(1));
            assertThat(session.isUp())
                    .as("what was to be requested over the second link is forgotten")
                    .isTrue();
            assertThat(cables.bauds).hasSize(3);
        }
    }

    @Test
    void aFrameThatTheCableWasPulledInCountsAsSkippedAndSpoilsNoOther() {
        try (RoombaSession session = session(cables::plugIn)) {
            session.open();
            cables.say(FRAME);
            cables.say(Arrays.copyOf(FRAME, 20));
            cables.hangUp();
            clock.advance(RobotConnection.LOOK);
            cables.say(FRAME);
            cables.say(FRAME);
            assertThat(session.isUp()).isTrue();
            assertThat(session.describe()).contains("3 frames", "20 bytes skipped");
        }
    }

    @Test
    void aRobotThatStopsReadingIsPluggedInAnew() {
        try (RoombaSession session = session(cables::plugIn)) {
            session.open();
            cables.say(FRAME);
            cables.stopReading();
            assertThatThrownBy(() -> session.send(new Command.Safe()))
                    .isInstanceOfSatisfying(
                            LinkException.class,
                            stalled -> assertThat(stalled.fault()).isEqualTo(Fault.NOT_READING));
            session.poll();
            assertThat(session.isUp()).isFalse();
            assertThat(session.describe()).contains("takes no bytes");
            clock.advance(RobotConnection.LOOK);
            cables.say(FRAME);
            assertThat(session.isUp()).isTrue();
            cables.heard();
            session.send(new Command.Safe());
            assertThat(cables.heard()).containsExactly(131);
        }
    }

    @Test
    void aFailureOfTheCableDoesNotEndTheConnectionsCare() {
        AtomicInteger pluggings = new AtomicInteger();
        IntFunction<Link> cable = baud -> {
            if (pluggings.incrementAndGet() == 2) {
                throw new IllegalStateException("a driver that fails once");
            }
            return cables.plugIn(baud);
        };
        try (RoombaSession session = session(cable)) {
            session.open();
            cables.say(FRAME);
            cables.hangUp();
            clock.advance(Duration.ofSeconds(1));
            cables.say(FRAME);
            assertThat(session.isUp()).isTrue();
        }
    }

    @Test
    void closingEndsTheWaitAndLeavesNoTimers() {
        RoombaSession session = session(cables::plugIn);
        session.open();
        clock.advance(RobotConnection.ANSWER_LIMIT);
        session.close();
        session.close();
        assertThatThrownBy(session::awaitRobot)
                .isInstanceOfSatisfying(
                        LinkException.class,
                        closed -> assertThat(closed.fault()).isEqualTo(Fault.CLOSED));
        cables.say(FRAME);
        clock.advance(RobotConnection.LOOK.plus(RobotConnection.WAKE_PULSE));
        assertThat(clock.pendingTasks()).isZero();
        assertThat(session.isUp()).isFalse();
    }

    @Test
    void aLinkThatOpensWhileTheSessionIsClosedIsClosedToo() throws InterruptedException {
        CountDownLatch mayOpen = new CountDownLatch(1);
        IntFunction<Link> slowCable = baud -> {
            try {
                mayOpen.await();
            } catch (InterruptedException stop) {
                Thread.currentThread().interrupt();
            }
            return cables.plugIn(baud);
        };
        RoombaSession session = new RoombaSession(slowCable, clock, SessionOptions.defaults());
        CompletableFuture<Void> opening = CompletableFuture.runAsync(session::open);
        CompletableFuture<Void> closing = CompletableFuture.runAsync(session::close);
        assertThatThrownBy(session::awaitRobot).isInstanceOf(LinkException.class);
        mayOpen.countDown();
        closing.join();
        opening.handle((done, failure) -> done).join();
        for (MemoryLink end : cables.ends()) {
            assertThatThrownBy(() -> end.send(new byte[1]))
                    .isInstanceOfSatisfying(
                            LinkException.class,
                            closed -> assertThat(closed.fault()).isEqualTo(Fault.CLOSED));
        }
    }

    @Test
    void aClockThatIsClosedFirstDoesNoHarm() {
        RoombaSession session = session(cables::plugIn);
        session.open();
        clock.close();
        session.close();
        assertThat(session.isUp()).isFalse();
    }

    @Test
    void aRobotGetsItsTimeAfterACommandThatChangesItsMode() throws InterruptedException {
        List<Long> sentNanos = new CopyOnWriteArrayList<>();
        try (Clock fast = new SystemClock(20);
                RoombaSession session = new RoombaSession(
                        baud -> new TimedLink(plugInAnswering(baud), fast, sentNanos),
                        fast,
                        SessionOptions.defaults())) {
            session.open();
            session.awaitRobot();
            session.send(new Command.Safe());
            session.send(new ActuatorCommand.DriveDirect(100, 100));
            assertThat(sentNanos.get(1) - sentNanos.get(0)).isGreaterThan(19_900_000);
        }
    }

    private Link plugInAnswering(int baud) {
        Link plugged = cables.plugIn(baud);
        cables.showAtOnce(1, Frames.resting(OiMode.PASSIVE));
        return plugged;
    }

    /** Records when Safe and DriveDirect are sent. */
    private static final class TimedLink extends ForwardingLink {
        private final Clock clock;
        private final List<Long> sentNanos;

        TimedLink(Link link, Clock clock, List<Long> sentNanos) {
            super(link);
            this.clock = clock;
            this.sentNanos = sentNanos;
        }

        @Override
        public void send(byte[] bytes) {
            super.send(bytes);
            if (bytes[0] == (byte) 131 || bytes[0] == (byte) 145) {
                sentNanos.add(clock.nanoTime());
            }
        }
    }
}
