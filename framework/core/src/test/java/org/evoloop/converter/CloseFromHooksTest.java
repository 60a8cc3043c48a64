package org.evoloop.converter;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.Set;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.awaitility.Awaitility;
import org.evoloop.LightBulb;
import org.evoloop.PaperModels;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Step;
import org.evoloop.function.Visit;
import org.evoloop.loop.LoopConfig;
import org.evoloop.loop.LoopState;
import org.evoloop.loop.ThreadingModel;
import org.evoloop.time.Clock;
import org.evoloop.time.SystemClock;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A converter is closed from code that it calls: nothing deadlocks, and no thread is left. */
@Timeout(60)
class CloseFromHooksTest {
    /** Longer than any of the tests needs, so that a wait that times out is logged as one. */
    private static final Duration JOIN = Duration.ofSeconds(2);

    private enum Hook {
        SEND,
        SETTLED,
        RELEASED,
        FUNCTION,
        END_OF_VISIT,
        TIMER,
        LISTENER
    }

    private final CountDownLatch called = new CountDownLatch(1);
    private final CountDownLatch mayClose = new CountDownLatch(1);
    private final Clock clock = new SystemClock();
    private final PushMonitor wallSwitch = new PushMonitor("WallSwitch");

    private SystemEventConverter lamp(String name, ThreadingModel threading, Hook hook) {
        SystemEventConverter converter = new SystemEventConverter(
                LoopConfig.defaults(name, clock).withThreading(threading).withJoinLimit(JOIN));
        converter.addMonitor(wallSwitch);
        converter.addExecute(new EventExecute("Lamp") {
            @Override
            protected Set<String> sendableEvents() {
                return Set.of("switch");
            }

            @Override
            protected void send(Step step) {
                closeIf(hook == Hook.SEND, converter);
            }

            @Override
            protected void settled(Configuration now) {
                closeIf(hook == Hook.SETTLED && now.evolved().name().equals("on"), converter);
            }

            @Override
            protected void released() {
                closeIf(hook == Hook.RELEASED, converter);
            }
        });
        converter.addKnowledge(new LightBulb(
                PaperModels.lightBulb(), Duration.ofMinutes(2), visit -> inFunction(hook, converter, visit)));
        converter.addListener(new ConverterListener() {
            @Override
            public void ended(HistoryEntry entry) {
                closeIf(hook == Hook.LISTENER, converter);
            }
        });
        return converter;
    }

    private void inFunction(Hook hook, SystemEventConverter converter, Visit visit) {
        visit.onEnd(() -> closeIf(hook == Hook.END_OF_VISIT, converter));
        if (hook == Hook.TIMER) {
            visit.after(Duration.ZERO, () -> closeIf(true, converter));
        }
        closeIf(hook == Hook.FUNCTION, converter);
    }

    private void closeIf(boolean wanted, SystemEventConverter converter) {
        if (wanted) {
            called.countDown();
            try {
                mayClose.await();
            } catch (InterruptedException closing) {
                Thread.currentThread().interrupt();
            }
            converter.close();
        }
    }

    /** @param meanwhile whether the program closes the converter at the same time */
    @ParameterizedTest
    @CsvSource({
        "SEND, SINGLE_CARRIER, false", "SEND, THREAD_PER_COMPONENT, true", "SETTLED, SINGLE_CARRIER, false",
        "SETTLED, THREAD_PER_COMPONENT, true", "FUNCTION, SINGLE_CARRIER, false", "FUNCTION, SINGLE_CARRIER, true",
        "TIMER, SINGLE_CARRIER, false", "TIMER, SINGLE_CARRIER, true", "LISTENER, SINGLE_CARRIER, false",
        "LISTENER, SINGLE_CARRIER, true", "RELEASED, SINGLE_CARRIER, true", "END_OF_VISIT, SINGLE_CARRIER, true"
    })
    void itEndsWithoutAWordAndWithoutAThread(Hook hook, ThreadingModel threading, boolean meanwhile) {
        String name = "closing-" + hook + "-" + threading + "-" + meanwhile;
        SystemEventConverter converter = lamp(name, threading, hook);
        try (LoggedLines log = new LoggedLines("org.evoloop")) {
            converter.build();
            converter.start();
            wallSwitch.press("switch");
            wallSwitch.press("switch");
            wallSwitch.press("switch");
            if (meanwhile) {
                Awaitility.await().until(() -> converter.status().events().handled() == 3 || called.getCount() == 0);
                mayClose.countDown();
                converter.close();
            }
            mayClose.countDown();

            Awaitility.await().until(() -> converter.status().loop() == LoopState.EXITED);
            Awaitility.await()
                    .atMost(20, TimeUnit.SECONDS)
                    .untilAsserted(() -> assertThat(Thread.getAllStackTraces().keySet())
                            .extracting(Thread::getName)
                            .noneMatch(thread -> thread.contains(name) || thread.startsWith("function-")));

            assertThat(called.getCount()).isZero();
            assertThat(log.lines()).noneMatch(line -> line.contains("did not end"));
        } finally {
            clock.close();
        }
    }
}
