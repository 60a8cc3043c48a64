package org.evoloop.converter;

import static org.assertj.core.api.Assertions.assertThat;
import static org.evoloop.converter.LiveRobot.await;
import static org.evoloop.converter.LiveRobot.until;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.stream.Stream;
import org.evoloop.loop.LoopState;
import org.evoloop.loop.ThreadingModel;
import org.evoloop.time.Clock;
import org.evoloop.time.SystemClock;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Whatever a component asks of its own converter, alone or while another thread closes it, returns at once or is
 * refused: two threads that waited for each other would wait for the join limit, which here exceeds the test's timeout.
 */
@Timeout(40)
class ChangeFromHooksTest {
    private static final Duration JOIN = Duration.ofMinutes(1);

    private enum Change {
        STOP,
        EXCHANGE,
        CLOSE
    }

    static Stream<Arguments> cases() {
        List<Arguments> cases = new ArrayList<>();
        for (Faulty.Part hook : Faulty.Part.values()) {
            for (Change change : Change.values()) {
                cases.add(Arguments.of(hook, change, false));
                cases.add(Arguments.of(hook, change, true));
            }
        }
        return cases.stream();
    }

    private final CountDownLatch called = new CountDownLatch(1);
    private final CountDownLatch mayAsk = new CountDownLatch(1);
    private final BlockingQueue<String> answers = new LinkedBlockingQueue<>();
    private final CountDownLatch built = new CountDownLatch(1);
    private volatile Faulty lamp;

    @AfterEach
    void close() {
        mayAsk.countDown();
        lamp.heals();
        lamp.close();
    }

    private Object ask(Change change) {
        called.countDown();
        boolean interrupted = false;
        while (mayAsk.getCount() > 0 || built.getCount() > 0) {
            try {
                built.await();
                mayAsk.await();
            } catch (InterruptedException closing) {
                interrupted = true;
            }
        }
        if (interrupted) {
            Thread.currentThread().interrupt();
        }
        try {
            switch (change) {
                case STOP -> lamp.converter.stop();
                case EXCHANGE -> lamp.converter.exchange("Brain", "NewBrain");
                case CLOSE -> lamp.converter.close();
            }
            answers.add("done");
        } catch (IllegalStateException | IllegalArgumentException refused) {
            answers.add(refused.getMessage());
        }
        return "press";
    }

    /** @param meanwhile whether the program closes the converter at the same time */
    @ParameterizedTest
    @MethodSource("cases")
    void returnsAtOnceOrIsRefused(Faulty.Part hook, Change change, boolean meanwhile) throws InterruptedException {
        try (Clock clock = new SystemClock();
                LoggedLines log = new LoggedLines("org.evoloop")) {
            lamp = new Faulty(hook, ThreadingModel.SINGLE_CARRIER, clock, JOIN, () -> ask(change));
            built.countDown();
            Thread program = new Thread(() -> run(hook), "program");
            program.start();
            if (meanwhile) {
                if (hook == Faulty.Part.RELEASED) {
                    // What was not started is not released.
                    program.join();
                } else {
                    await(called);
                }
                Thread closing = new Thread(lamp.converter::close, "closing");
                closing.start();
                until(() -> lamp.converter.status().loop() == LoopState.EXITED || hook == Faulty.Part.SETTLED);
                mayAsk.countDown();
                closing.join();
            } else {
                mayAsk.countDown();
            }
            program.join();
            if (hook == Faulty.Part.RELEASED) {
                lamp.converter.stop();
            }
            String answer = LiveRobot.take(answers);
            lamp.heals();
            lamp.converter.close();

            assertThat(answer)
                    .matches("done|.*(was not changed|has ended|is being|is not built|there is a component|"
                            + "no component is named).*");
            assertThat(lamp.converter.status().loop()).isEqualTo(LoopState.EXITED);
            assertThat(log.lines()).noneMatch(line -> line.contains("did not end") || line.contains("left to itself"));
            until(() -> Thread.getAllStackTraces().keySet().stream()
                    .noneMatch(thread -> thread.getName().contains("faulty")
                            || thread.getName().startsWith("function-")));
        }
    }

    /**
     * What a program does. Some of it may be refused because the converter is stopped; this test does not check that.
     */
    private void run(Faulty.Part hook) {
        // The task runs some time after the state was entered.
        List<String> events = hook == Faulty.Part.TASK ? List.of("dim") : List.of("press", "press", "dim", "press");
        try {
            lamp.converter.start();
            for (String event : events) {
                if (hook == Faulty.Part.FUNCTION || hook == Faulty.Part.END_OF_VISIT) {
                    // A function that is left before its thread has run does not run.
                    lamp.press(event);
                } else {
                    lamp.wallSwitch.press(event);
                }
            }
            until(() -> called.getCount() == 0
                    || (hook != Faulty.Part.TASK
                            && lamp.converter.status().events().handled() == events.size())
                    || lamp.converter.status().loop() != LoopState.RUNNING);
        } catch (IllegalStateException closed) {
            assertThat(closed).hasMessageMatching(".*(stopped|closed|has ended|being closed).*");
        } catch (InterruptedException ended) {
            throw new AssertionError(ended);
        }
    }
}
