package org.evoloop.time;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class ManualClockTest {
    private final ManualClock clock = new ManualClock();
    private final List<String> ran = new ArrayList<>();

    private Clock.Timer at(long millis, String name) {
        return clock.schedule(Duration.ofMillis(millis), () -> ran.add(name + "@" + clock.nanoTime() / 1_000_000));
    }

    @Test
    void runsWhatIsDueInTheOrderOfItsTimes() {
        at(20, "second");
        at(10, "first");
        at(20, "third");
        at(31, "late");

        clock.advance(Duration.ofMillis(30));

        assertThat(ran).containsExactly("first@10", "second@20", "third@20");
        assertThat(clock.nanoTime()).isEqualTo(30_000_000);
        assertThat(clock.wallTime()).isEqualTo(Instant.EPOCH.plusMillis(30));
        assertThat(clock.pendingTasks()).isEqualTo(1);
    }

    @Test
    void runsWhatDueWorkSchedulesInTheSameAdvance() {
        clock.schedule(Duration.ofMillis(5), () -> at(5, "again"));

        clock.advance(Duration.ofMillis(10));

        assertThat(ran).containsExactly("again@10");
    }

    @Test
    void reportsTheTimeUntilTheNextTask() {
        assertThat(clock.untilNext()).isEmpty();
        at(20, "late");
        at(10, "soon");
        assertThat(clock.untilNext()).contains(Duration.ofMillis(10));

        clock.advance(Duration.ofMillis(12));

        assertThat(clock.untilNext()).contains(Duration.ofMillis(8));
    }

    @Test
    void forgetsWhatWasCancelled() {
        Clock.Timer timer = at(5, "never");
        timer.cancel();
        timer.cancel();

        clock.advance(Duration.ofMillis(10));

        assertThat(ran).isEmpty();
        assertThat(clock.pendingTasks()).isZero();
    }

    @Test
    void wakesASleeperWhenItsTimeHasCome() throws InterruptedException {
        Thread sleeper = new Thread(() -> {
            try {
                clock.sleep(Duration.ofSeconds(3));
                ran.add("awake");
            } catch (InterruptedException e) {
                ran.add("interrupted");
            }
        });
        sleeper.start();
        while (clock.pendingTasks() == 0) {
            Thread.onSpinWait();
        }
        clock.advance(Duration.ofMillis(2999));
        assertThat(ran).isEmpty();
        clock.advance(Duration.ofMillis(1));
        sleeper.join();
        assertThat(ran).containsExactly("awake");
    }
}
