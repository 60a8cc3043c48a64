package org.evoloop.converter;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.evoloop.LightBulb;
import org.evoloop.RecordingExecute;
import org.evoloop.evolution.Decision;
import org.evoloop.loop.LoopConfig;
import org.evoloop.time.SystemClock;
import org.evoloop.time.Threads;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** A removed listener costs nothing any more; until then it receives what an event led to. */
class ListenerRemovalTest {
    private final SystemClock clock = new SystemClock();
    private final PushMonitor wallSwitch = new PushMonitor("WallSwitch");
    private final SystemEventConverter converter =
            new SystemEventConverter(LoopConfig.defaults("removal", clock).withQueueCapacity(20));

    private static final class Heard implements ConverterListener {
        final CopyOnWriteArrayList<HistoryEntry> entries = new CopyOnWriteArrayList<>();
        final CountDownLatch first = new CountDownLatch(1);

        @Override
        public void ended(HistoryEntry entry) {
            entries.add(entry);
            first.countDown();
        }
    }

    @AfterEach
    void close() {
        converter.close();
        clock.close();
    }

    private void build() {
        converter.addMonitor(wallSwitch);
        converter.addExecute(new RecordingExecute("Lamp", "switch"));
        converter.addKnowledge(new LightBulb());
        converter.build();
        converter.start();
    }

    private static Thread listenersThread() {
        return Thread.getAllStackTraces().keySet().stream()
                .filter(thread -> thread.getName().equals("mapek-removal-listeners"))
                .findFirst()
                .orElse(null);
    }

    @Test
    void theThreadEndsWithTheLastListenerAndBeginsWithTheNext() throws Exception {
        build();
        Heard heard = new Heard();
        converter.addListener(heard);
        Thread first = listenersThread();
        converter.removeListener(heard);
        assertThat(Threads.join(first, Duration.ofSeconds(10))).isTrue();

        Heard next = new Heard();
        converter.addListener(next);
        wallSwitch.press("switch");
        assertThat(next.first.await(10, TimeUnit.SECONDS)).isTrue();
        assertThat(heard.entries).isEmpty();
    }

    @Test
    void whatEndedBeforeTheConverterIsClosedIsHeard() {
        build();
        Heard heard = new Heard();
        converter.addListener(heard);
        for (int presses = 0; presses < 20; presses++) {
            wallSwitch.press("switch");
        }
        converter.close();
        assertThat(heard.entries).isNotEmpty().isEqualTo(converter.history());
    }

    @Test
    void anEntrySaysWhatTheEventMeantAndHowLongItTook() throws Exception {
        build();
        Heard heard = new Heard();
        converter.addListener(heard);
        wallSwitch.press("switch");
        assertThat(heard.first.await(10, TimeUnit.SECONDS)).isTrue();

        HistoryEntry entry = heard.entries.get(0);
        assertThat(entry.decision()).isInstanceOf(Decision.ExistingState.class);
        assertThat(entry.decision().steps()).hasToString("[off --switch--> on]");
        assertThat(entry.took()).isPositive();
        assertThat(converter.history().get(0).decision()).isEqualTo(entry.decision());
    }

    @Test
    void aListenerThatInterruptsItselfHearsOfTheNextEvent() throws Exception {
        build();
        CountDownLatch second = new CountDownLatch(2);
        converter.addListener(new ConverterListener() {
            @Override
            public void ended(HistoryEntry entry) {
                second.countDown();
                Thread.currentThread().interrupt();
            }
        });
        wallSwitch.press("switch");
        wallSwitch.press("switch");
        assertThat(second.await(10, TimeUnit.SECONDS)).isTrue();
    }
}
