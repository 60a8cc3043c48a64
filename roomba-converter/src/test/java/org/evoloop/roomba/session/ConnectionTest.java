package org.evoloop.roomba.session;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.function.IntFunction;
import org.evoloop.roomba.link.Link;
import org.evoloop.roomba.link.LinkException;
import org.evoloop.roomba.link.LinkException.Fault;
import org.evoloop.roomba.link.MemoryLink;
import org.evoloop.roomba.oi.ActuatorCommand;
import org.evoloop.roomba.oi.Command;
import org.evoloop.roomba.oi.InputCommand;
import org.evoloop.roomba.oi.StreamFrame;
import org.evoloop.time.Clock;
import org.evoloop.time.ManualClock;
import org.evoloop.time.SystemClock;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** The connection step by step, at a cable in memory whose other end says only what a test lets it say. */
@Timeout(30)
class ConnectionTest {
    private static final byte[] FRAME = StreamFrame.encode(RoombaSession.STREAM, packet -> 0);
    private static final Duration LONG = Duration.ofSeconds(30);

    private final ManualClock clock = new ManualClock();
    private final List<Integer> bauds = new ArrayList<>();
    private final List<MemoryLink.Pair> cables = new ArrayList<>();
    private final ByteArrayOutputStream heard = new ByteArrayOutputStream();

    private Link plugIn(int baud) {
        MemoryLink.Pair fresh = MemoryLink.pair();
        fresh.robot().open(new Link.Receiver() {
            @Override
            public void received(byte[] buffer, int length) {
                heard.write(buffer, 0, length);
            }

            @Override
            public void lost(LinkException cause) {
                // The robot's side does not mind.
            }
        });
        bauds.add(baud);
        cables.add(fresh);
        return fresh.converter();
    }

    private RoombaSession session(IntFunction<Link> cable) {
        return new RoombaSession(cable, clock, SessionOptions.defaults().withoutWaiting());
    }

    private void say(byte[] bytes) {
        cables.get(cables.size() - 1).robot().send(bytes);
    }

    @Test
    void aRobotThatAnswersWhileItIsWokenIsNotDisturbedAnyMore() {
        try (RoombaSession session = session(this::plugIn)) {
            session.open();
            clock.advance(Connection.ANSWER_LIMIT.plusMillis(100));
            heard.reset();
            say(FRAME);
            clock.advance(Connection.WAKE_PULSE.plusMillis(300));
            assertThat(session.isUp()).isTrue();
            assertThat(heard.toByteArray())
                    .as("a Start would end the control that was taken meanwhile")
                    .isEmpty();
        }
    }

    @Test
    void aSilentRobotIsToldAtTheAlternateRateToComeBack() {
        try (RoombaSession session = session(this::plugIn)) {
            session.open();
            while (bauds.size() < 2) {
                heard.reset();
                clock.advance(Duration.ofMillis(10));
            }
            say(FRAME);
            assertThat(session.isUp())
                    .as("a frame at the rate that is about to end does not count")
                    .isFalse();
            while (bauds.size() < 3) {
                clock.advance(Duration.ofMillis(10));
            }
            assertThat(bauds).containsExactly(115_200, 19_200, 115_200);
            byte[] told = heard.toByteArray();
            byte[] rate = new Command.Baud(115_200).bytes();
            assertThat(told).containsSubsequence(rate[0], rate[1]);
            assertThat(told)
                    .as("what could be pending is completed first")
                    .startsWith(new byte[] {(byte) 128, (byte) 128});
            say(FRAME);
            assertThat(session.isUp()).isTrue();
        }
    }

    @Test
    void aRobotThatNeverAnswersIsDiagnosedAndStillWaitedFor() {
        try (RoombaSession session = session(this::plugIn)) {
            session.open();
            clock.advance(LONG);
            assertThatThrownBy(session::awaitRobot)
                    .isInstanceOf(RobotException.class)
                    .hasMessageContaining("no answer at 115200 nor 19200 baud")
                    .hasMessageContaining("Press CLEAN");
            while (bauds.get(bauds.size() - 1) != 115_200) {
                clock.advance(Connection.LOOK);
            }
            say(FRAME);
            assertThat(session.isUp()).isTrue();
        }
    }

    @Test
    void aCableThatIsPulledBeforeTheRobotAnswersEndsTheWait() {
        try (RoombaSession session = session(this::plugIn)) {
            session.open();
            cables.get(0).converter().hangUp();
            assertThatThrownBy(session::awaitRobot)
                    .isInstanceOfSatisfying(
                            LinkException.class,
                            lost -> assertThat(lost.fault()).isEqualTo(Fault.HUNG_UP));
        }
    }

    @Test
    void aRobotThatFallsSilentIsAskedAgain() {
        try (RoombaSession session = session(this::plugIn)) {
            session.open();
            say(FRAME);
            assertThat(session.isUp()).isTrue();
            heard.reset();
            clock.advance(SessionOptions.defaults()
                    .silenceLimit()
                    .plus(Connection.LOOK)
                    .plus(Connection.MODE_CHANGE));
            assertThat(session.isUp()).isFalse();
            assertThat(session.describe()).contains("fallen silent");
            ByteArrayOutputStream question = new ByteArrayOutputStream();
            question.writeBytes(new Command.Start().bytes());
            question.writeBytes(new InputCommand.Stream(RoombaSession.STREAM).bytes());
            assertThat(heard.toByteArray()).isEqualTo(question.toByteArray());
            say(FRAME);
            assertThat(session.isUp()).isTrue();
        }
    }

    @Test
    void aFailureOfTheCableDoesNotEndTheConnectionsCare() {
        IntFunction<Link> cable = baud -> {
            if (cables.size() == 1) {
                cables.add(MemoryLink.pair());
                throw new IllegalStateException("a driver that fails once");
            }
            return plugIn(baud);
        };
        try (RoombaSession session = session(cable)) {
            session.open();
            say(FRAME);
            cables.get(0).converter().hangUp();
            clock.advance(Duration.ofSeconds(1));
            say(FRAME);
            assertThat(session.isUp()).isTrue();
        }
    }

    @Test
    void closingEndsTheWaitAndLeavesNoTimers() {
        RoombaSession session = session(this::plugIn);
        session.open();
        clock.advance(Connection.ANSWER_LIMIT);
        session.close();
        session.close();
        assertThatThrownBy(session::awaitRobot)
                .isInstanceOfSatisfying(
                        LinkException.class,
                        closed -> assertThat(closed.fault()).isEqualTo(Fault.CLOSED));
        say(FRAME);
        clock.advance(Connection.LOOK.plus(Connection.WAKE_PULSE));
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
            return plugIn(baud);
        };
        RoombaSession session = new RoombaSession(slowCable, clock, SessionOptions.defaults());
        CompletableFuture<Void> opening = CompletableFuture.runAsync(session::open);
        CompletableFuture<Void> closing = CompletableFuture.runAsync(session::close);
        assertThatThrownBy(session::awaitRobot).isInstanceOf(LinkException.class);
        mayOpen.countDown();
        closing.join();
        opening.handle((done, failure) -> done).join();
        for (MemoryLink.Pair cable : cables) {
            assertThatThrownBy(() -> cable.converter().send(new byte[1]))
                    .isInstanceOfSatisfying(
                            LinkException.class,
                            closed -> assertThat(closed.fault()).isEqualTo(Fault.CLOSED));
        }
    }

    @Test
    void aClockThatIsClosedFirstDoesNoHarm() {
        RoombaSession session = session(this::plugIn);
        session.open();
        clock.close();
        session.close();
        assertThat(session.isUp()).isFalse();
    }

    @Test
    void aRobotGetsItsTimeAfterACommandThatChangesItsMode() {
        List<Long> heardNanos = new CopyOnWriteArrayList<>();
        MemoryLink.Pair pair = MemoryLink.pair();
        try (Clock fast = new SystemClock(20);
                RoombaSession session = new RoombaSession(baud -> pair.converter(), fast, SessionOptions.defaults())) {
            pair.robot().open(new Link.Receiver() {
                @Override
                public void received(byte[] buffer, int length) {
                    if (buffer[0] == (byte) 131 || buffer[0] == (byte) 145) {
                        heardNanos.add(fast.nanoTime());
                    }
                }

                @Override
                public void lost(LinkException cause) {
                    // The robot's side does not mind.
                }
            });
            session.open();
            session.send(new Command.Safe());
            session.send(new ActuatorCommand.DriveDirect(100, 100));
            assertThat(heardNanos.get(1) - heardNanos.get(0)).isGreaterThan(19_900_000);
        }
    }
}
