package org.evoloop.converter;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.evoloop.converter.LiveRobot.until;

import java.time.Duration;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.atomic.AtomicLong;
import org.evoloop.evolution.Occurrence;
import org.evoloop.function.NewFunction;
import org.evoloop.function.Visit;
import org.evoloop.loop.LoopState;
import org.evoloop.time.Clock;
import org.evoloop.time.ManualClock;
import org.evoloop.time.SystemClock;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Calls that would wait forever, or for themselves, fail or do not wait. */
@Timeout(60)
class WrongModeTest {
    private final LoggedLines log = new LoggedLines(SystemEventConverter.class.getName());

    @AfterEach
    void detach() {
        log.close();
    }

    @Test
    void aVisitCannotSleepWithoutThreads() throws InterruptedException {
        try (Robot robot = new Robot()) {
            robot.controller("Clean").controller("Spot");
            Visit visit = robot.moving;
            assertThat(visit).isNotNull();
            assertThatThrownBy(() -> visit.sleep(Duration.ofSeconds(1)))
                    .isInstanceOf(IllegalStateException.class)
                    .hasMessage("visit.sleep would wait for ever: the converter has no threads; use after or "
                            + "finishAfter");
            assertThatThrownBy(visit::awaitEnd)
                    .isInstanceOf(IllegalStateException.class)
                    .hasMessage("visit.awaitEnd would wait for ever: the converter has no threads; use onEnd");
        }
    }

    @Test
    void aTaskOfTheClockCannotWaitForTheClock() throws InterruptedException {
        try (ManualClock manual = new ManualClock();
                SystemClock system = new SystemClock()) {
            for (Clock clock : List.of(manual, system)) {
                BlockingQueue<Exception> refused = new LinkedBlockingQueue<>();
                clock.schedule(Duration.ofMillis(1), () -> {
                    try {
                        clock.sleep(Duration.ofSeconds(1));
                    } catch (IllegalStateException | InterruptedException expected) {
                        refused.add(expected);
                    }
                });
                manual.advance(Duration.ofMillis(1));
                assertThat(LiveRobot.take(refused))
                        .hasMessage("a task of the clock cannot wait for the clock; schedule what comes after");
                assertThat(clock.ownsCurrentThread()).isFalse();
            }
        }
    }

    @Test
    void theMonitorsOfAConverterWithThreadsAreNotAskedByOthers() {
        try (LiveRobot robot = new LiveRobot(NewFunction.none())) {
            assertThatThrownBy(() -> robot.converter.observe(robot.panel))
                    .isInstanceOf(IllegalStateException.class)
                    .hasMessage("the loop robot has threads; they take the steps");
        }
        try (Robot robot = new Robot()) {
            assertThatThrownBy(() -> robot.converter.observe(new PushMonitor("Stranger")))
                    .isInstanceOf(IllegalArgumentException.class)
                    .hasMessage("Stranger is not part of the loop robot");
        }
    }

    @Test
    void aMonitorThatReturnsNothingWithoutWaitingIsNamedAndPolledSeldom() {
        AtomicLong asked = new AtomicLong();
        try (LiveRobot robot = new LiveRobot(NewFunction.none(), 8, made -> {
            made.converter.addMonitor(new EventMonitor("Idle") {
                @Override
                protected @Nullable Occurrence getEvent() {
                    asked.incrementAndGet();
                    return null;
                }
            });
            made.converter.addExecute(made.device("Device"));
        })) {
            until(() -> robot.component("Idle").failures() == 1);
            assertThat(robot.component("Idle").lastFailure())
                    .isEqualTo("Idle.getEvent: keeps returning null without waiting; from now on it is called only "
                            + "every 10 ms");
            long before = asked.get();
            until(() -> asked.get() > before + 3);
            assertThat(robot.component("Idle").failures()).isEqualTo(1);
            robot.press("Clean");
        }
    }

    @Test
    void closeWithinAComponentReturnsAtOnceAndNoComponentIsBlamed() {
        CountDownLatch returned = new CountDownLatch(1);
        LiveRobot robot = new LiveRobot(
                NewFunction.none(),
                8,
                made -> made.converter.addExecute(made.device("Device", step -> {
                    made.converter.close();
                    assertThat(made.component("Device").activity().name()).isEqualTo("WORKING");
                    returned.countDown();
                })));
        robot.panel.press("Clean");
        assertClosed(robot, returned);
    }

    @Test
    void closeWithinAFunctionOrItsTasksDoesToo() {
        CountDownLatch returned = new CountDownLatch(2);
        AtomicLong robots = new AtomicLong();
        LiveRobot[] live = new LiveRobot[1];
        CountDownLatch ready = new CountDownLatch(1);
        NewFunction move = visit -> {
            LiveRobot.await(ready);
            robots.incrementAndGet();
            visit.after(Duration.ofMillis(1), () -> {
                live[0].converter.close();
                returned.countDown();
            });
            returned.countDown();
        };
        LiveRobot robot = new LiveRobot(move);
        live[0] = robot;
        ready.countDown();
        robot.press("Clean", "Spot");
        until(() -> returned.getCount() == 1);
        robot.clock.advance(Duration.ofMillis(1));
        assertClosed(robot, returned);
        assertThat(robots).hasValue(1);
    }

    private void assertClosed(LiveRobot robot, CountDownLatch returned) {
        try {
            LiveRobot.await(returned);
        } catch (InterruptedException stop) {
            throw new AssertionError(stop);
        }
        until(() -> robot.converter.status().loop() == LoopState.EXITED
                && robot.converter.status().components().stream()
                        .allMatch(component -> component.activity().name().equals("ENDED")));
        assertThat(log.lines()).noneMatch(line -> line.contains("did not end") || line.contains("did not return"));
    }
}
