package org.evoloop.converter;

import static org.assertj.core.api.Assertions.assertThat;
import static org.evoloop.Machines.machine;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import org.evoloop.RecordingExecute;
import org.evoloop.converter.ConverterStatus.RunningTimer;
import org.evoloop.evolution.ModelPair;
import org.evoloop.loop.LoopConfig;
import org.evoloop.time.ManualClock;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** A door that closes by itself, after a warning, unless somebody closes it before: how long is left. */
class RunningTimersTest {
    private final ManualClock clock = new ManualClock();
    private final PushMonitor button = new PushMonitor("Button");
    private final SystemEventConverter door =
            new SystemEventConverter(LoopConfig.defaults("door", clock).withoutThreads());

    @BeforeEach
    void begin() {
        door.addMonitor(button);
        door.addExecute(new RecordingExecute("Motor", "press"));
        door.addKnowledge(
                new StateKnowledge(new ModelPair(
                        machine("original", "Closed press -> Open", "Open press -> Closed"),
                        machine(
                                "new",
                                "Closed press -> Open",
                                "Open press -> Closed",
                                "Open tm(5min) -> Closed",
                                "Open warn => Open"))) {
                    @Override
                    protected void registerNewFunctions() {
                        timer("Open", "warn", Duration.ofMinutes(4));
                    }
                });
        door.build();
        door.start();
    }

    @AfterEach
    void end() {
        door.close();
        clock.close();
    }

    private void press() throws InterruptedException {
        button.press("press");
        work();
    }

    private void work() throws InterruptedException {
        door.observe(button);
        while (door.step()) {}
    }

    private List<String> shown() {
        return door.status().timers().stream().map(RunningTimer::describe).toList();
    }

    @Test
    void theRemainingTimeRunsDownAndTheMomentStays() throws InterruptedException {
        assertThat(shown()).as("a closed door waits for nothing").isEmpty();
        press();
        Instant opened = clock.wallTime();
        assertThat(shown()).containsExactly("warn in 4 min 0 s", "tm(5min) in 5 min 0 s");

        clock.advance(Duration.ofSeconds(235));
        assertThat(shown()).containsExactly("warn in 5.0 s", "tm(5min) in 65 s");
        assertThat(door.status().timers())
                .extracting(RunningTimer::due)
                .containsExactly(opened.plusSeconds(240), opened.plusSeconds(300));

        clock.advance(Duration.ofSeconds(10));
        work();
        assertThat(shown()).as("one has fired").containsExactly("tm(5min) in 55 s");
    }

    @Test
    void noneRunsInAnotherStateNorWhileItIsStopped() throws InterruptedException {
        press();
        press();
        assertThat(shown()).isEmpty();
        press();
        door.stop();
        assertThat(shown()).isEmpty();
        door.start();
        assertThat(shown()).as("a new visit").containsExactly("warn in 4 min 0 s", "tm(5min) in 5 min 0 s");
    }
}
