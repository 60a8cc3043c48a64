package org.evoloop.converter;

import static org.assertj.core.api.Assertions.assertThat;
import static org.evoloop.converter.LiveRobot.await;
import static org.evoloop.converter.LiveRobot.awaitDeaf;
import static org.evoloop.converter.LiveRobot.until;

import java.io.IOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import org.evoloop.evolution.Outcome;
import org.evoloop.loop.ComponentStatus;
import org.evoloop.loop.LoopState;
import org.evoloop.loop.ThreadingModel;
import org.evoloop.time.ManualClock;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

/** A fault of one component affects only that component's work, is counted, and is logged with the component's name. */
@Timeout(60)
class ContainedTest {
    private final ManualClock clock = new ManualClock();
    private final CountDownLatch begun = new CountDownLatch(1);
    private final CountDownLatch atLast = new CountDownLatch(1);
    private final List<Faulty> open = new ArrayList<>();

    @AfterEach
    void close() {
        atLast.countDown();
        open.forEach(Faulty::close);
        until(() -> Thread.getAllStackTraces().keySet().stream()
                .noneMatch(thread ->
                        thread.getName().contains("faulty") || thread.getName().startsWith("function-")));
    }

    private Faulty lamp(Faulty.Part part, ThreadingModel threading, Faulty.Fault fault) {
        Faulty lamp = new Faulty(part, threading, clock, LiveRobot.SHORT_JOIN, fault);
        open.add(lamp);
        return lamp;
    }

    private Object hang() {
        begun.countDown();
        awaitDeaf(atLast);
        return "press";
    }

    /** Makes the component do its work. */
    private void provoke(Faulty lamp, String presses) throws InterruptedException {
        lamp.converter.start();
        for (String event : presses.split(" ")) {
            long before = ended(lamp);
            lamp.press(event);
            until(() -> ended(lamp) > before || begun.getCount() == 0);
        }
        clock.advance(Duration.ofMillis(1));
    }

    private static long ended(Faulty lamp) {
        return lamp.converter.history().size();
    }

    /** Everything that is reported as failed, with the message. */
    private static List<String> named(Faulty lamp) {
        List<String> named = new ArrayList<>();
        for (ComponentStatus component : lamp.converter.status().components()) {
            if (component.failures() > 0) {
                named.add(component.name() + " " + component.lastFailure());
            }
        }
        for (ConverterStatus.Fault fault : lamp.converter.status().faults()) {
            named.add(fault.part() + " " + fault.lastFailure());
        }
        return named;
    }

    private static void awaitHangs(Faulty lamp, String name) {
        until(() -> named(lamp).stream()
                .anyMatch(line -> line.startsWith(name + " ")
                        && (line.contains("has not returned for 30000 ms")
                                || line.contains("is stuck in its thread"))));
    }

    private void continues(Faulty lamp, String event) {
        lamp.heals();
        long handled = lamp.converter.status().events().handled();
        lamp.wallSwitch.press(event);
        until(() -> lamp.converter.status().events().handled() > handled);
    }

    @ParameterizedTest
    @CsvSource({
        "MONITOR, SINGLE_CARRIER, press, Ear",
        "ANALYZE, SINGLE_CARRIER, press, Brain",
        "PLAN, THREAD_PER_COMPONENT, press, Will",
        "EXECUTE, SINGLE_CARRIER, press, Lamp",
        "GUARD, SINGLE_CARRIER, press, guard [dark]",
        "EFFECT, THREAD_PER_COMPONENT, press, effect beep",
        "FUNCTION, SINGLE_CARRIER, dim, function Dim",
        "TASK, SINGLE_CARRIER, dim, function Dim",
        "SETTLED, SINGLE_CARRIER, press, Lamp",
        "END_OF_VISIT, SINGLE_CARRIER, dim press, function Dim",
        "LISTENER, SINGLE_CARRIER, press, listener "
    })
    void whatThrowsIsCountedAndNamed(Faulty.Part part, ThreadingModel threading, String presses, String name)
            throws InterruptedException {
        Faulty lamp = lamp(part, threading, () -> {
            throw new IOException("it is broken");
        });
        provoke(lamp, presses);
        until(() ->
                named(lamp).stream().anyMatch(line -> line.startsWith(name.strip()) && line.contains("it is broken")));
        continues(lamp, "press");
        until(lamp.converter::stop);
    }

    @ParameterizedTest
    @CsvSource({"ANALYZE, SINGLE_CARRIER, Brain", "PLAN, THREAD_PER_COMPONENT, Will"})
    void whatReturnsNullForeverIsCountedAndNamed(Faulty.Part part, ThreadingModel threading, String name)
            throws InterruptedException {
        Faulty lamp = lamp(part, threading, () -> null);
        provoke(lamp, "press ".repeat(49).strip());
        assertThat(named(lamp)).as("it may be intended").isEmpty();
        provoke(lamp, "press");
        until(() -> named(lamp).stream()
                .anyMatch(line -> line.startsWith(name) && line.contains("has returned null 50 times in a row")));
        assertThat(lamp.converter.status().events().ignored()).isEqualTo(50);
        continues(lamp, "press");
    }

    @ParameterizedTest
    @CsvSource({
        "ANALYZE, SINGLE_CARRIER, press, Brain, Brain",
        "PLAN, THREAD_PER_COMPONENT, press, Will, Will",
        "EXECUTE, SINGLE_CARRIER, press, Lamp, Lamp",
        "EXECUTE, THREAD_PER_COMPONENT, press, Lamp, Lamp",
        "GUARD, SINGLE_CARRIER, press, guard [dark], Brain",
        "EFFECT, SINGLE_CARRIER, press, effect beep, Lamp",
        "END_OF_VISIT, SINGLE_CARRIER, dim press, Lamp, Lamp"
    })
    void whatHangsInTheLoopIsNamedAndWhoCallsItCanBeExchanged(
            Faulty.Part part, ThreadingModel threading, String presses, String name, String component)
            throws InterruptedException {
        Faulty lamp = lamp(part, threading, this::hang);
        provoke(lamp, presses);
        await(begun);
        assertThat(lamp.converter.status().components())
                .anyMatch(status -> status.activity() == ComponentStatus.Activity.WORKING
                        && status.name().equals(component));

        clock.advance(LiveRobot.STEP_LIMIT);
        awaitHangs(lamp, name);
        assertThat(lamp.converter.status().components())
                .anyMatch(status -> status.activity() == ComponentStatus.Activity.STUCK
                        && status.name().equals(component));
        lamp.heals();
        lamp.converter.exchange(component, "New" + component);
        // A guard that hangs is not evaluated again, so events that need it keep failing.
        continues(lamp, part == Faulty.Part.GUARD ? "dim" : "press");
        until(lamp.converter::stop);
    }

    /** The device has obeyed before, so the system must not stay behind. */
    @ParameterizedTest
    @EnumSource(names = {"SINGLE_CARRIER", "THREAD_PER_COMPONENT"})
    void aTransitionIsTakenThoughItsEffectHangs(ThreadingModel threading) throws InterruptedException {
        Faulty lamp = lamp(Faulty.Part.EFFECT, threading, this::hang);
        provoke(lamp, "press");
        await(begun);

        clock.advance(LiveRobot.STEP_LIMIT);
        until(() -> ended(lamp) == 1);
        HistoryEntry press = lamp.converter.history().get(0);
        assertThat(press.outcome()).isEqualTo(Outcome.FAILED);
        assertThat(press.after()).isEqualTo(Robot.at("On", "On"));
        assertThat(press.detail())
                .isEqualTo(
                        "it is unknown whether the effect beep was run: Lamp.execute: has not returned for 30000 ms");
    }

    @ParameterizedTest
    @CsvSource({
        "MONITOR, press",
        "ANALYZE, press",
        "PLAN, press",
        "EXECUTE, press",
        "GUARD, press",
        "EFFECT, press",
        "FUNCTION, dim",
        "TASK, dim",
        "END_OF_VISIT, dim press",
        "LISTENER, press",
        "RELEASED, press"
    })
    void stopAnswersAndIsDoneWhileItHangs(Faulty.Part part, String presses) throws InterruptedException {
        Faulty lamp = new Faulty(part, ThreadingModel.SINGLE_CARRIER, clock, Duration.ofMinutes(1), this::hang);
        open.add(lamp);
        provoke(lamp, presses);
        if (part != Faulty.Part.RELEASED) {
            await(begun);
        }

        // Well within the minute in which it has to return.
        if (part == Faulty.Part.MONITOR || part == Faulty.Part.LISTENER) {
            until(lamp.converter::stop);
        } else {
            assertThat(lamp.converter.stop()).as("everything has ended").isFalse();
        }

        assertThat(lamp.converter.status().loop()).isEqualTo(LoopState.STOPPED);
        atLast.countDown();
        until(lamp.converter::stop);
    }

    @ParameterizedTest
    @CsvSource({"ANALYZE, press", "EXECUTE, press", "FUNCTION, dim", "TASK, dim", "RELEASED, press", "SETTLED, press"})
    void closeComesToItsEndWhileItHangs(Faulty.Part part, String presses) throws InterruptedException {
        Faulty lamp = lamp(part, ThreadingModel.SINGLE_CARRIER, this::hang);
        if (part == Faulty.Part.SETTLED) {
            Thread starting = new Thread(lamp.converter::start, "starting");
            starting.start();
            await(begun);
            lamp.converter.close();
            starting.join();
        } else {
            provoke(lamp, presses);
            lamp.converter.close();
            await(begun);
        }
        assertThat(lamp.converter.status().loop()).isEqualTo(LoopState.EXITED);
        assertThat(atLast.getCount()).isEqualTo(1);
    }

    @ParameterizedTest
    @CsvSource({"FUNCTION", "TASK"})
    void aFunctionThatHangsIsNamedByItsThread(Faulty.Part part) throws InterruptedException {
        Faulty lamp = lamp(part, ThreadingModel.SINGLE_CARRIER, this::hang);
        provoke(lamp, "dim");
        await(begun);
        until(() -> lamp.converter.status().function().thread().startsWith("function-Dim-"));
        CountDownLatch later = new CountDownLatch(1);
        clock.schedule(Duration.ofMillis(1), later::countDown);
        clock.advance(Duration.ofMillis(1));
        assertThat(later.getCount()).as("the clock still works").isZero();
        continues(lamp, "press");
    }

    @ParameterizedTest
    @CsvSource({"ANALYZE, press", "PLAN, press"})
    void whatReturnsNullForeverIsCounted(Faulty.Part part, String event) throws InterruptedException {
        Faulty lamp = lamp(part, ThreadingModel.SINGLE_CARRIER, () -> null);
        provoke(lamp, event);
        until(() -> lamp.converter.status().events().ignored() == 1);
        assertThat(lamp.converter.history().get(0).detail()).isEqualTo("dismissed");
        continues(lamp, "press");
    }
}
