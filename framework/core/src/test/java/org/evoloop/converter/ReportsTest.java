package org.evoloop.converter;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;

import java.time.Duration;
import org.evoloop.PaperModels;
import org.evoloop.RecordingExecute;
import org.evoloop.function.NewFunction;
import org.evoloop.loop.LoopConfig;
import org.evoloop.time.Clock;
import org.evoloop.time.ManualClock;
import org.evoloop.time.SystemClock;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** How repeated errors, and errors on the clock's thread, are logged. */
@Timeout(60)
class ReportsTest {
    private final LoggedLines log = new LoggedLines(SystemEventConverter.class.getName());
    private final PushMonitor panel = new PushMonitor("Panel");

    @AfterEach
    void detach() {
        log.close();
    }

    /** A robot in standby. */
    private SystemEventConverter robot(LoopConfig config, NewFunction move) {
        SystemEventConverter converter = new SystemEventConverter(config);
        converter.addMonitor(panel);
        converter.addExecute(new RecordingExecute("Device", "Clean", "Spot"));
        StateKnowledge knowledge = new StateKnowledge(PaperModels.cleaningRobot());
        knowledge.function("Move", move);
        knowledge.function("SpotWait", NewFunction.none());
        converter.addKnowledge(knowledge);
        converter.build();
        converter.start();
        return converter;
    }

    @Test
    void aTaskOfAVisitThatThrowsIsReportedLikeItsFunction() throws InterruptedException {
        ManualClock clock = new ManualClock();
        NewFunction move = visit -> {
            visit.after(Duration.ofSeconds(1), () -> {
                throw new IllegalArgumentException("no such wheel");
            });
            visit.after(Duration.ofSeconds(2), () -> visit.say("goes on"));
        };
        try (SystemEventConverter converter =
                robot(LoopConfig.defaults("robot", clock).withoutThreads(), move)) {
            for (String event : new String[] {"Clean", "Spot"}) {
                panel.press(event);
                converter.observe(panel);
                converter.step();
            }
            clock.advance(Duration.ofSeconds(3));
            assertThat(log.lines()).containsExactly("Move.function: no such wheel");
            assertThat(clock.nanoTime()).isEqualTo(3_000_000_000L);
        }
    }

    @Test
    void onTheClocksOwnThreadToo() {
        try (Clock clock = new SystemClock();
                SystemEventConverter converter = robot(
                        LoopConfig.defaults("robot", clock),
                        visit -> visit.after(Duration.ofMillis(1), () -> {
                            throw new AssertionError("no such wheel");
                        }))) {
            panel.press("Clean");
            panel.press("Spot");
            LiveRobot.until(() -> log.lines().contains("Move.function: no such wheel"));
            assertThat(converter.status().states()).isEqualTo(Robot.at("On", "Move"));
        }
    }

    @Test
    void aQueueThatIsFullAgainAndAgainIsReportedMoreAndMoreSeldom() throws InterruptedException {
        LoopConfig config =
                LoopConfig.defaults("robot", new ManualClock()).withoutThreads().withQueueCapacity(1);
        try (SystemEventConverter converter = robot(config, NewFunction.none())) {
            for (int burst = 0; burst < 1000; burst++) {
                panel.press("Clean");
                for (int lost = 0; lost < 3; lost++) {
                    assertThatIllegalStateException().isThrownBy(() -> panel.press("Clean"));
                }
                converter.step();
            }
            assertThat(converter.status().queue().dropped()).isEqualTo(3000);
            assertThat(log.lines())
                    .hasSize(10)
                    .startsWith(
                            "the queue of 1 events is full, and events are lost; status counts them, history names them")
                    .last()
                    .asString()
                    .endsWith("(512 times)");
        }
    }
}
