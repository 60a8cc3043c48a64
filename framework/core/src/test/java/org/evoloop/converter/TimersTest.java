package org.evoloop.converter;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.evoloop.converter.LiveRobot.await;
import static org.evoloop.converter.LiveRobot.awaitDeaf;
import static org.evoloop.converter.LiveRobot.until;
import static org.evoloop.converter.Robot.at;

import java.time.Duration;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import org.evoloop.RecordingExecute;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Outcome;
import org.evoloop.evolution.Source;
import org.evoloop.evolution.Values;
import org.evoloop.function.NewFunction;
import org.evoloop.loop.LoopConfig;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.time.ManualClock;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Timers belong to one visit to a state. */
@Timeout(60)
class TimersTest {
    @Test
    void aTimerThatFiresWhileItsStateIsBeingLeftComesTooLate() throws InterruptedException {
        CountDownLatch sending = new CountDownLatch(1);
        CountDownLatch fired = new CountDownLatch(1);
        try (LiveRobot robot = new LiveRobot(NewFunction.none(), 8, made -> {
            made.converter.addExecute(made.device("Device", step -> {
                if (step.event().name().equals("Spot")) {
                    sending.countDown();
                    fired.await();
                }
            }));
        })) {
            robot.press("Clean", "Clean", "Clean").awaitSpotWait();
            robot.panel.press("Clean");
            await(sending);
            robot.clock.advance(Duration.ofSeconds(6));
            fired.countDown();
            robot.awaitStates("Spot", "Spot");
            robot.panel.ended("endSpot");
            robot.awaitStates("On", "On");
            assertThat(robot.converter.history())
                    .extracting(entry -> entry.occurrence().label())
                    .doesNotContain("timeout");
        }
    }

    @Test
    void aTimeoutThatIsQueuedBehindTheEventThatLeavesItsStateIsStale() throws InterruptedException {
        CountDownLatch analyzing = new CountDownLatch(1);
        CountDownLatch queued = new CountDownLatch(1);
        AtomicReference<String> held = new AtomicReference<>("");
        try (LiveRobot robot = new LiveRobot(NewFunction.none(), 8, made -> {
            made.converter.addAnalyze(new EventAnalyze() {
                @Override
                protected @Nullable Analysis analyze(Occurrence occurrence) {
                    if (occurrence.label().equals(held.get())) {
                        analyzing.countDown();
                        awaitDeaf(queued);
                    }
                    return super.analyze(occurrence);
                }
            });
            made.converter.addExecute(made.device("Device"));
        })) {
            robot.press("Clean", "Clean", "Clean").awaitSpotWait();
            held.set("Clean");
            robot.panel.press("Clean");
            await(analyzing);
            robot.clock.advance(Duration.ofSeconds(5));
            until(() -> robot.converter.status().queue().depth() == 1);
            queued.countDown();

            HistoryEntry stale = robot.awaitHistory(5);
            assertThat(stale.outcome()).isEqualTo(Outcome.STALE);
            assertThat(stale.occurrence().label()).isEqualTo("timeout");
            assertThat(stale.detail()).isEqualTo("the state that raised it has been left");
            assertThat(robot.states()).isEqualTo(at("Spot", "Spot"));
        }
    }

    @Test
    void aFunctionThatFinishesWhileTheQueueIsFullDoesNotHoldTheClockUp() throws InterruptedException {
        CountDownLatch analyzing = new CountDownLatch(1);
        CountDownLatch advanced = new CountDownLatch(1);
        AtomicReference<String> held = new AtomicReference<>("");
        try (LiveRobot robot = new LiveRobot(NewFunction.none(), 1, made -> {
            made.converter.addAnalyze(new EventAnalyze() {
                @Override
                protected @Nullable Analysis analyze(Occurrence occurrence) {
                    if (occurrence.label().equals(held.get())) {
                        analyzing.countDown();
                        awaitDeaf(advanced);
                    }
                    return super.analyze(occurrence);
                }
            });
            made.converter.addExecute(made.device("Device"));
        })) {
            robot.press("Clean", "Clean", "Clean").awaitSpotWait();
            held.set("Spot");
            robot.panel.press("Spot");
            await(analyzing);
            robot.panel.press("Spot");
            until(() -> robot.converter.status().queue().depth() == 1);

            Thread ticking = new Thread(() -> robot.clock.advance(Duration.ofSeconds(5)));
            ticking.start();
            ticking.join(TimeUnit.SECONDS.toMillis(10));
            boolean clockGoesOn = !ticking.isAlive();
            advanced.countDown();

            assertThat(clockGoesOn).isTrue();
            robot.awaitStates("On", "On");
        }
    }

    /** A lamp that goes out by itself and blinks before that: time triggers in an old and in a new state. */
    private static final ModelPair LAMP = new ModelPair(
            StateMachine.named("original")
                    .initial("off")
                    .transition("off", "switch", "on")
                    .transition("on", "switch", "off")
                    .build(),
            StateMachine.named("new")
                    .initial("off")
                    .transition("off", "switch", "on")
                    .transition("on", "switch", "off")
                    .transition("on", "tm(10s)", "dim")
                    .transition("dim", "switch", "on")
                    .transition("dim", "after 2 s", "off")
                    .build());

    @Test
    void timeTriggersOfTheModelNeedNoCode() throws InterruptedException {
        ManualClock clock = new ManualClock();
        SystemEventConverter converter =
                new SystemEventConverter(LoopConfig.defaults("lamp", clock).withoutThreads());
        PushMonitor wall = new PushMonitor("Wall");
        converter.addMonitor(wall);
        converter.addKnowledge(new StateKnowledge(LAMP));
        converter.addExecute(new RecordingExecute("Lamp", "switch"));
        converter.build();
        converter.start();
        wall.press("switch");
        converter.observe(wall);
        converter.step();
        assertThat(clock.pendingTasks()).isEqualTo(1);

        pass(converter, clock, 9_999, "on", "on");
        pass(converter, clock, 1, "on", "dim");
        wall.press("switch");
        converter.observe(wall);
        converter.step();
        assertThat(converter.knowledge().configuration())
                .as("the device is on already")
                .isEqualTo(at("on", "on"));
        pass(converter, clock, 10_000, "on", "dim");
        pass(converter, clock, 1_999, "on", "dim");
        pass(converter, clock, 1, "off", "off");
        assertThat(clock.pendingTasks()).isZero();
        assertThat(converter.history())
                .extracting(HistoryEntry::detail)
                .containsExactly("switch", "new function of dim", "", "new function of dim", "switch");
        converter.close();
    }

    private static void pass(
            SystemEventConverter converter, ManualClock clock, long millis, String original, String evolved) {
        clock.advance(Duration.ofMillis(millis));
        while (converter.step()) {
            assertThat(converter.history()).isNotEmpty();
        }
        assertThat(converter.knowledge().configuration()).isEqualTo(at(original, evolved));
    }

    @Test
    void anOccurrenceFromTheFutureIsRefusedSoThatTimersAreNotLate() throws InterruptedException {
        try (Robot robot = new Robot()) {
            Occurrence early = new Occurrence.Heard(
                    new Event("Clean"),
                    Values.NONE,
                    Source.CONTROLLER,
                    Occurrence.ANY_VISIT,
                    Duration.ofHours(16).toNanos());
            assertThatThrownBy(() -> robot.converter.offer(early))
                    .isInstanceOf(IllegalArgumentException.class)
                    .hasMessageContaining("observed 57600000 ms in the future");
            robot.controller("Clean").controller("Clean").controller("Clean");
            assertThat(robot.states().evolved()).hasToString("SpotWait");
            robot.pass(Duration.ofSeconds(5));
            assertThat(robot.last().occurrence().label()).isEqualTo("timeout");
        }
    }
}
