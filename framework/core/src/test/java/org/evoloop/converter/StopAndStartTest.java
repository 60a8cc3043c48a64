package org.evoloop.converter;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.evoloop.converter.LiveRobot.await;
import static org.evoloop.converter.LiveRobot.awaitDeaf;
import static org.evoloop.converter.LiveRobot.take;
import static org.evoloop.converter.LiveRobot.until;
import static org.evoloop.converter.Robot.at;

import java.io.IOException;
import java.time.Duration;
import java.util.List;
import java.util.Set;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Outcome;
import org.evoloop.evolution.Step;
import org.evoloop.function.NewFunction;
import org.evoloop.loop.InEachThreading;
import org.evoloop.loop.LoopState;
import org.evoloop.loop.ThreadingModel;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@InEachThreading
@Timeout(60)
class StopAndStartTest {
    private final ThreadingModel threading;

    StopAndStartTest(ThreadingModel threading) {
        this.threading = threading;
    }

    private final CountDownLatch sending = new CountDownLatch(1);
    private final CountDownLatch mayGo = new CountDownLatch(1);

    @Test
    void stopLetsTheEventInTheLoopComeToItsEndAndRefusesThoseThatWait() throws InterruptedException {
        try (LiveRobot robot = new LiveRobot(threading, NewFunction.none(), 8, made -> {
            made.converter.addExecute(made.device("Device", step -> {
                if (step.source().name().equals("On")) {
                    sending.countDown();
                    // Well within the time that a stop allows.
                    until(() -> made.converter.status().loop() == LoopState.STOPPED);
                }
            }));
        })) {
            robot.press("Clean");
            robot.panel.press("Clean");
            await(sending);
            robot.panel.press("Clean");
            until(() -> robot.converter.status().queue().depth() == 1);

            until(robot.converter::stop);

            assertThat(robot.states()).isEqualTo(at("Clean", "Clean"));
            assertThat(robot.converter.status().queue().refused()).isEqualTo(1);
            assertThat(robot.converter.history())
                    .extracting(HistoryEntry::outcome)
                    .containsExactly(Outcome.HANDLED, Outcome.HANDLED);
        }
    }

    @Test
    void stopGivesUpAnEventThatDoesNotComeToItsEnd() throws InterruptedException {
        try (LiveRobot robot = new LiveRobot(threading, NewFunction.none(), 8, made -> {
            made.converter.addExecute(made.device("Device", step -> {
                sending.countDown();
                awaitDeaf(mayGo);
            }));
        })) {
            robot.panel.press("Clean");
            await(sending);
            until(robot.converter::stop);

            assertThat(robot.converter.status().loop()).isEqualTo(LoopState.STOPPED);
            assertThat(robot.awaitHistory(1).outcome()).isEqualTo(Outcome.FAILED);
            assertThat(robot.converter.status().function().state()).isEmpty();
            assertThat(robot.heard).contains("Device released");
            assertThat(robot.converter.status().doubt()).contains("it is unknown whether Clean had its effect");
            mayGo.countDown();
            assertThat(take(robot.sent)).isEqualTo("Device:Clean");
            robot.awaitStates("On", "Off");
            assertThat(robot.converter.status().doubt()).isEmpty();
        }
    }

    @Test
    void whileTheLoopIsClosedControllersAreRefusedAndTheRecordFollowsTheDevice() {
        try (LiveRobot robot = new LiveRobot(threading, NewFunction.none())) {
            robot.press("Clean");
            until(robot.converter::stop);
            robot.panel.pressed("Clean", true);
            robot.awaitStates("Clean", "On");
            until(() -> robot.converter.status().queue().depth() == 1);
            assertThat(robot.converter.status().queue().refused()).isZero();

            robot.converter.start();
            robot.awaitHistory(2);
            assertThat(robot.states()).isEqualTo(at("Clean", "Clean"));
            robot.press("Clean");
            assertThat(robot.states()).isEqualTo(at("Clean", "SpotWait"));
        }
    }

    @Test
    void theFunctionEndsWithStopAndBeginsAnewWithStart() throws InterruptedException {
        BlockingQueue<String> life = new LinkedBlockingQueue<>();
        try (LiveRobot robot = new LiveRobot(threading, visit -> {
            life.add("begins");
            try {
                visit.awaitEnd();
                life.add("is notified");
            } catch (InterruptedException left) {
                life.add("is interrupted");
            }
        })) {
            robot.press("Clean", "Spot");
            assertThat(take(life)).isEqualTo("begins");
            until(robot.converter::stop);
            assertThat(take(life)).startsWith("is ");
            assertThat(robot.converter.status().function()).isEqualTo(ConverterStatus.RunningFunction.NONE);

            robot.converter.start();
            assertThat(take(life)).isEqualTo("begins");
            assertThat(robot.converter.status().function())
                    .isEqualTo(new ConverterStatus.RunningFunction("Move", "function-Move-4", "", List.of()));
        }
    }

    @Test
    void aTimerOfTheStateInWhichItWasStoppedStartsAnew() throws InterruptedException {
        try (LiveRobot robot = new LiveRobot(threading, NewFunction.none())) {
            robot.press("Clean", "Clean", "Clean").awaitSpotWait();
            robot.clock.advance(Duration.ofSeconds(4));
            until(robot.converter::stop);
            robot.clock.advance(Duration.ofSeconds(10));
            robot.converter.start();
            robot.awaitSpotWait();
            robot.clock.advance(Duration.ofMillis(4999));
            robot.press("Spot");
            assertThat(robot.states()).isEqualTo(at("Clean", "SpotWait"));
            robot.clock.advance(Duration.ofMillis(1));
            robot.awaitStates("On", "On");
        }
    }

    @Test
    void executesAreNotifiedBeforeTheLoopOpensAndAfterItHasClosed() {
        try (LiveRobot robot = new LiveRobot(threading, NewFunction.none())) {
            robot.press("Clean");
            until(robot.converter::stop);
            until(robot.converter::stop);
            robot.converter.start();
            robot.converter.start();
            robot.converter.close();
            robot.converter.close();
            assertThatThrownBy(robot.converter::start).hasMessage("the loop robot has ended");
            assertThat(robot.heard)
                    .containsExactly(
                            "Device settled at (Off, Off)",
                            "Device settled at (On, On)",
                            "Device released",
                            "Device settled at (On, On)",
                            "Device released");
        }
    }

    @Test
    void anExecuteThatFailsInItsHooksDelaysNothing() {
        EventExecute rude = new EventExecute("Rude") {
            @Override
            protected Set<String> sendableEvents() {
                return Set.of("Clean", "Spot");
            }

            @Override
            protected void send(Step step) {}

            @Override
            protected void settled(Configuration now) throws Exception {
                throw new IOException("not now");
            }

            @Override
            protected void released() throws Exception {
                throw new IOException("never");
            }
        };
        CountDownLatch moving = new CountDownLatch(1);
        try (LiveRobot robot =
                new LiveRobot(threading, visit -> moving.countDown(), 8, made -> made.converter.addExecute(rude))) {
            robot.press("Clean", "Spot");
            awaitDeaf(moving);
            assertThat(robot.states()).isEqualTo(at("On", "Move"));
            until(() -> robot.component("Rude").failures() == 3);
            assertThat(robot.component("Rude").lastFailure()).isEqualTo("Rude.execute: not now");
            until(robot.converter::stop);
            assertThat(robot.converter.status().loop()).isEqualTo(LoopState.STOPPED);
        }
    }

    @Test
    void everyThreadEndsWithTheConverter() {
        LiveRobot robot = new LiveRobot(threading, visit -> visit.awaitEnd());
        robot.press("Clean", "Spot");
        robot.close();
        assertThat(Thread.getAllStackTraces().keySet())
                .extracting(Thread::getName)
                .noneMatch(name -> name.startsWith("mapek-robot-") || name.startsWith("function-Move-"));
        assertThat(robot.clock.pendingTasks()).isLessThanOrEqualTo(1);
    }
}
