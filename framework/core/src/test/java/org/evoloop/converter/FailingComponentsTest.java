package org.evoloop.converter;

import static org.assertj.core.api.Assertions.assertThat;
import static org.evoloop.converter.LiveRobot.await;
import static org.evoloop.converter.LiveRobot.awaitDeaf;
import static org.evoloop.converter.LiveRobot.take;
import static org.evoloop.converter.LiveRobot.until;
import static org.evoloop.converter.Robot.at;

import java.io.IOException;
import java.time.Duration;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.atomic.AtomicReference;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Outcome;
import org.evoloop.function.NewFunction;
import org.evoloop.loop.ComponentStatus.Activity;
import org.evoloop.loop.InEachThreading;
import org.evoloop.loop.ThreadingModel;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** A component of a running converter that throws or hangs affects only the event in progress. */
@InEachThreading
@Timeout(60)
class FailingComponentsTest {
    private final ThreadingModel threading;

    FailingComponentsTest(ThreadingModel threading) {
        this.threading = threading;
    }

    @Test
    void aMonitorThatThrowsIsReportedAndTheOtherOneContinues() {
        CountDownLatch broken = new CountDownLatch(1);
        EventMonitor brokenMonitor = new EventMonitor("Broken") {
            @Override
            protected @Nullable Occurrence getEvent() throws IOException {
                broken.countDown();
                throw new IOException("no such device");
            }
        };
        try (LiveRobot robot = new LiveRobot(threading, NewFunction.none(), 8, made -> {
            made.converter.addMonitor(brokenMonitor);
            made.converter.addExecute(made.device("Device"));
        })) {
            awaitDeaf(broken);
            robot.press("Clean", "Clean");
            assertThat(robot.states()).isEqualTo(at("Clean", "Clean"));
            until(() -> robot.component("Broken").failures() > 0);
            assertThat(robot.component("Broken").lastFailure()).isEqualTo("Broken.getEvent: no such device");
            assertThat(robot.converter.status().events().failed())
                    .as("no event has failed")
                    .isZero();
        }
    }

    @Test
    void anExecuteThatThrowsFailsItsEventOnly() {
        AtomicReference<Exception> fault = new AtomicReference<>(new IOException("the cable is out"));
        try (LiveRobot robot = new LiveRobot(threading, NewFunction.none(), 8, made -> {
            made.converter.addExecute(made.device("Device", step -> {
                if (fault.get() != null) {
                    throw fault.get();
                }
            }));
        })) {
            robot.press("Clean");
            HistoryEntry failed = robot.awaitHistory(1);
            assertThat(failed.outcome()).isEqualTo(Outcome.FAILED);
            assertThat(failed.detail()).isEqualTo("Device.execute: the cable is out");
            assertThat(failed.before()).isEqualTo(failed.after()).isEqualTo(at("Off", "Off"));
            assertThat(robot.component("Device").failures()).isEqualTo(1);

            fault.set(null);
            robot.press("Clean");
            assertThat(robot.states()).isEqualTo(at("On", "On"));
        }
    }

    @Test
    void anExecuteThatHangsIsGivenUpAndTheStateItWasToLeaveIsEnteredAnew() throws InterruptedException {
        CountDownLatch hanging = new CountDownLatch(1);
        CountDownLatch never = new CountDownLatch(1);
        try (LiveRobot robot = new LiveRobot(threading, NewFunction.none(), 8, made -> {
            made.converter.addExecute(made.device("Device", step -> {
                if (step.event().name().equals("Spot")) {
                    hanging.countDown();
                    never.await();
                }
            }));
        })) {
            robot.press("Clean", "Clean", "Clean").awaitSpotWait();
            robot.panel.press("Clean");
            await(hanging);
            robot.clock.advance(LiveRobot.STEP_LIMIT);

            assertThat(robot.awaitHistory(5).detail())
                    .isEqualTo("the device cannot tell where it is; it is taken to be in On");
            HistoryEntry failed = robot.awaitHistory(4);
            assertThat(failed.outcome()).isEqualTo(Outcome.FAILED);
            assertThat(failed.detail()).isEqualTo("Device.execute: has not returned for 30000 ms");
            assertThat(failed.before()).isEqualTo(at("Clean", "SpotWait"));
            assertThat(failed.after())
                    .as("the first of two events has had its effect")
                    .isEqualTo(at("On", "SpotWait"));
            until(() -> robot.component("Device").activity() == Activity.WAITING);
            robot.awaitSpotWait();
            robot.clock.advance(Duration.ofSeconds(5));
            robot.awaitStates("On", "On");
        }
    }

    @Test
    void anExecuteThatReturnsLateShowsWhereTheDeviceIs() throws InterruptedException {
        CountDownLatch hanging = new CountDownLatch(1);
        CountDownLatch atLast = new CountDownLatch(1);
        try (LiveRobot robot = new LiveRobot(threading, NewFunction.none(), 8, made -> {
            made.converter.addExecute(made.device("Deaf", step -> {
                if (step.event().name().equals("Spot")) {
                    hanging.countDown();
                    awaitDeaf(atLast);
                }
            }));
        })) {
            robot.press("Clean", "Clean", "Clean");
            robot.panel.press("Clean");
            await(hanging);
            robot.clock.advance(LiveRobot.STEP_LIMIT);
            robot.awaitHistory(4);
            assertThat(robot.component("Deaf").activity()).isEqualTo(Activity.STUCK);
            robot.press("Clean");
            assertThat(robot.awaitHistory(6).detail()).contains("is stuck").contains("exchange it");

            robot.sent.clear();
            atLast.countDown();
            assertThat(take(robot.sent)).isEqualTo("Deaf:Spot");
            until(() -> robot.component("Deaf").activity() == Activity.WAITING);
            assertThat(robot.awaitHistory(7).detail()).isEqualTo("the device was found in Spot");
            assertThat(robot.states()).isEqualTo(at("Spot", "SpotWait"));
        }
    }

    @Test
    void aFunctionThatThrowsIsReportedAndItsStateCanBeLeft() throws InterruptedException {
        try (LiveRobot robot = new LiveRobot(threading, visit -> {
            throw new IllegalStateException("no camera");
        })) {
            robot.press("Clean", "Spot").awaitStates("On", "Move");
            assertThat(robot.awaitHistory(2).outcome()).isEqualTo(Outcome.HANDLED);
            until(() -> robot.converter.status().function().thread().isEmpty());
            robot.press("arriveSpot");
            assertThat(robot.states()).isEqualTo(at("Spot", "Spot"));
        }
    }

    @Test
    void aFunctionThatIgnoresInterruptsIsLeftBehindAndItsLateEventMeansNothing() throws InterruptedException {
        CountDownLatch atLast = new CountDownLatch(1);
        BlockingQueue<Thread> threads = new LinkedBlockingQueue<>();
        try (LiveRobot robot = new LiveRobot(threading, visit -> {
            threads.add(Thread.currentThread());
            awaitDeaf(atLast);
            visit.finish("arriveSpot");
        })) {
            robot.press("Clean", "Spot");
            Thread function = take(threads);
            assertThat(function.getName()).isEqualTo("function-Move-3");
            robot.press("arriveSpot").awaitStates("Spot", "Spot");
            assertThat(function.isAlive()).isTrue();

            atLast.countDown();
            function.join();
            robot.press("Clean");
            assertThat(robot.converter.history()).hasSize(4);
            assertThat(robot.states()).isEqualTo(at("Spot", "Spot"));
        }
    }

    @Test
    void anAnalyzeThatHangsIsGivenUpAndTheNextEventIsNotInterruptedInItsPlace() throws InterruptedException {
        CountDownLatch hanging = new CountDownLatch(1);
        CountDownLatch atLast = new CountDownLatch(1);
        CountDownLatch secondRuns = new CountDownLatch(1);
        CountDownLatch secondMayEnd = new CountDownLatch(1);
        EventAnalyze slow = new EventAnalyze() {
            private int calls;

            @Override
            protected @Nullable Analysis analyze(Occurrence occurrence) {
                if (++calls == 1) {
                    hanging.countDown();
                    awaitDeaf(atLast);
                } else if (calls == 2) {
                    secondRuns.countDown();
                    try {
                        await(secondMayEnd);
                    } catch (InterruptedException spurious) {
                        throw new IllegalStateException("interrupted for another event", spurious);
                    }
                }
                return super.analyze(occurrence);
            }
        };
        try (LiveRobot robot = new LiveRobot(threading, NewFunction.none(), 8, made -> {
            made.converter.addAnalyze(slow);
            made.converter.addExecute(made.device("Device"));
        })) {
            robot.panel.press("Clean");
            await(hanging);
            robot.clock.advance(LiveRobot.STEP_LIMIT);
            assertThat(robot.awaitHistory(1).outcome()).isEqualTo(Outcome.FAILED);
            robot.press("Clean");
            assertThat(robot.awaitHistory(2).detail()).contains("is stuck").contains("exchange it");

            atLast.countDown();
            until(() -> robot.component(slow.name()).activity() == Activity.WAITING);
            robot.panel.press("Clean");
            await(secondRuns);
            secondMayEnd.countDown();
            assertThat(robot.awaitHistory(3).outcome()).isEqualTo(Outcome.HANDLED);
            assertThat(robot.states()).isEqualTo(at("On", "On"));
        }
    }
}
