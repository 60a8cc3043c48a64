package org.evoloop.converter;

import java.time.Duration;
import java.util.Set;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import org.evoloop.PaperModels;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Step;
import org.evoloop.function.NewFunction;
import org.evoloop.loop.ComponentStatus;
import org.evoloop.loop.LoopConfig;
import org.evoloop.loop.ThreadingModel;
import org.evoloop.time.ManualClock;

/** The paper's cleaning robot as a converter with threads and a manual clock; tests control what its components do. */
public final class LiveRobot implements AutoCloseable {
    static final Duration STEP_LIMIT = Duration.ofSeconds(30);
    static final Duration SHORT_JOIN = Duration.ofMillis(50);
    private static final int PATIENCE_SECONDS = 20;

    final ManualClock clock = new ManualClock();
    final Robot.Panel panel = new Robot.Panel();
    final BlockingQueue<String> sent = new LinkedBlockingQueue<>();
    final BlockingQueue<String> heard = new LinkedBlockingQueue<>();
    final SystemEventConverter converter;
    private final BlockingQueue<Long> spotWaits = new LinkedBlockingQueue<>();

    /** A robot whose device accepts everything that is sent, and whose Move runs {@code move}. */
    LiveRobot(NewFunction move) {
        this(ThreadingModel.SINGLE_CARRIER, move);
    }

    LiveRobot(ThreadingModel threading, NewFunction move) {
        this(threading, move, 8, robot -> robot.converter.addExecute(robot.device("Device")));
    }

    LiveRobot(NewFunction move, int queueCapacity, Consumer<LiveRobot> parts) {
        this(ThreadingModel.SINGLE_CARRIER, move, queueCapacity, parts);
    }

    /** @param parts adds the execute components, and anything else that the test needs */
    LiveRobot(ThreadingModel threading, NewFunction move, int queueCapacity, Consumer<LiveRobot> parts) {
        converter = new SystemEventConverter(LoopConfig.defaults("robot", clock)
                .withThreading(threading)
                .withQueueCapacity(queueCapacity)
                .withStepLimit(STEP_LIMIT)
                .withJoinLimit(SHORT_JOIN));
        converter.addMonitor(panel);
        converter.addKnowledge(new StateKnowledge(PaperModels.cleaningRobot()) {
            @Override
            protected void registerNewFunctions() {
                function("Move", move);
                function("SpotWait", visit -> {
                    visit.finishAfter(Duration.ofSeconds(5), "timeout");
                    spotWaits.add(visit.number());
                });
            }
        });
        parts.accept(this);
        converter.build();
        converter.start();
    }

    /** How a device handles an event. */
    interface Taking {
        void take(Step step) throws Exception;
    }

    Device device(String name) {
        return device(name, step -> {});
    }

    /** A device that notes every event once {@code taking} has returned. */
    Device device(String name, Taking taking) {
        return new Device(name, Set.of("Clean", "Spot"), taking);
    }

    final class Device extends EventExecute {
        private final Set<String> sendable;
        private final Taking taking;

        Device(String name, Set<String> sendable, Taking taking) {
            super(name);
            this.sendable = sendable;
            this.taking = taking;
        }

        @Override
        protected Set<String> sendableEvents() {
            return sendable;
        }

        @Override
        protected void send(Step step) throws Exception {
            taking.take(step);
            sent.add(name() + ":" + step.event());
        }

        @Override
        protected void settled(Configuration now) {
            heard.add(name() + " settled at " + now);
        }

        @Override
        protected void released() {
            heard.add(name() + " released");
        }
    }

    /** Presses controller buttons one after another, each after the previous event has ended. */
    LiveRobot press(String... events) {
        for (String event : events) {
            int before = converter.history().size();
            panel.press(event);
            awaitHistory(before + 1);
        }
        return this;
    }

    /** Waits until this many events have ended; returns the last one. */
    HistoryEntry awaitHistory(int entries) {
        until(() -> converter.history().size() >= entries);
        return converter.history().get(entries - 1);
    }

    LiveRobot awaitStates(String original, String evolved) {
        until(() -> states().equals(Robot.at(original, evolved)));
        return this;
    }

    /** Waits until the function of SpotWait has started again and set its timer. */
    LiveRobot awaitSpotWait() throws InterruptedException {
        take(spotWaits);
        return this;
    }

    Configuration states() {
        return converter.knowledge().configuration();
    }

    ComponentStatus component(String name) {
        return converter.status().components().stream()
                .filter(component -> component.name().equals(name))
                .findFirst()
                .orElseThrow();
    }

    /** Polls for a condition that no latch signals. */
    static void until(BooleanSupplier holds) {
        long deadline = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE_SECONDS);
        while (!holds.getAsBoolean()) {
            if (System.nanoTime() > deadline) {
                throw new AssertionError("never came to hold");
            }
            Thread.onSpinWait();
        }
    }

    public static void await(CountDownLatch latch) throws InterruptedException {
        if (!latch.await(PATIENCE_SECONDS, TimeUnit.SECONDS)) {
            throw new AssertionError("never happened");
        }
    }

    /** Waits like code that ignores interrupts. */
    public static void awaitDeaf(CountDownLatch latch) {
        boolean interrupted = false;
        while (latch.getCount() > 0) {
            try {
                latch.await();
            } catch (InterruptedException ignored) {
                interrupted = true;
            }
        }
        if (interrupted) {
            Thread.currentThread().interrupt();
        }
    }

    static <T> T take(BlockingQueue<T> queue) throws InterruptedException {
        T taken = queue.poll(PATIENCE_SECONDS, TimeUnit.SECONDS);
        if (taken == null) {
            throw new AssertionError("nothing came");
        }
        return taken;
    }

    @Override
    public void close() {
        converter.close();
    }
}
