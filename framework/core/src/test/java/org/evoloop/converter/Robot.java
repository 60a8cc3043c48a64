package org.evoloop.converter;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.evoloop.PaperModels;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Step;
import org.evoloop.function.Visit;
import org.evoloop.loop.LoopConfig;
import org.evoloop.statemachine.State;
import org.evoloop.time.ManualClock;
import org.jspecify.annotations.Nullable;

/** The paper's cleaning robot as a converter without threads; the device records what it was sent. */
final class Robot implements AutoCloseable {
    final ManualClock clock = new ManualClock();
    final List<String> sent = new ArrayList<>();
    final List<String> settled = new ArrayList<>();
    final Panel panel = new Panel();
    final SystemEventConverter converter;

    @Nullable
    Exception brokenCable;

    int soundSteps = Integer.MAX_VALUE;

    @Nullable
    Visit moving;

    final List<String> moves = new ArrayList<>();

    Robot() {
        this(8);
    }

    Robot(int queueCapacity) {
        converter = new SystemEventConverter(
                LoopConfig.defaults("robot", clock).withoutThreads().withQueueCapacity(queueCapacity));
        converter.addMonitor(panel);
        converter.addExecute(new Device());
        converter.addKnowledge(new KnowledgeState());
        converter.build();
        converter.start();
    }

    static final class Panel extends PushMonitor {
        void pressed(String event, boolean deviceActed) {
            push(fromPanel(event, deviceActed));
        }

        void ended(String event) {
            push(fromDevice(event));
        }

        void found(String state) {
            push(foundIn(state));
        }

        @Override
        protected Set<String> spontaneousEvents() {
            return Set.of("Clean", "Spot", "endSpot");
        }
    }

    final class Device extends EventExecute {
        @Override
        protected Set<String> sendableEvents() {
            return Set.of("Clean", "Spot");
        }

        @Override
        protected void send(Step step) throws Exception {
            Exception fault = brokenCable;
            if (fault != null && sent.size() >= soundSteps) {
                throw fault;
            }
            sent.add(step.event().name());
        }

        @Override
        protected void settled(Configuration now) {
            settled.add(now.toString());
        }
    }

    final class KnowledgeState extends StateKnowledge {
        KnowledgeState() {
            super(PaperModels.cleaningRobot());
        }

        @Override
        protected void registerNewFunctions() {
            function("Move", this::move);
            function("SpotWait", visit -> visit.finishAfter(Duration.ofSeconds(5), "timeout"));
        }

        private void move(Visit visit) {
            moving = visit;
            moves.add("starts");
            visit.onEnd(() -> moves.add("ends"));
        }
    }

    /** Processes the panel's and the functions' events until none waits. */
    void settle() throws InterruptedException {
        converter.observe(panel);
        while (converter.step()) {
            converter.observe(panel);
        }
    }

    /** A control of the controller is operated. */
    Robot controller(String event) throws InterruptedException {
        panel.press(event);
        settle();
        return this;
    }

    /** A button of the robot is pressed. */
    Robot panel(String event, boolean deviceActed) throws InterruptedException {
        panel.pressed(event, deviceActed);
        settle();
        return this;
    }

    Robot device(String event) throws InterruptedException {
        panel.ended(event);
        settle();
        return this;
    }

    /** The robot is found in this state. */
    Robot found(String state) throws InterruptedException {
        panel.found(state);
        settle();
        return this;
    }

    Robot pass(Duration duration) throws InterruptedException {
        clock.advance(duration);
        settle();
        return this;
    }

    Robot arrives() throws InterruptedException {
        Visit visit = moving;
        if (visit == null) {
            throw new AssertionError("Move has not started");
        }
        visit.say("Arrive at target point");
        visit.finish("arriveSpot");
        settle();
        return this;
    }

    Configuration states() {
        return converter.knowledge().configuration();
    }

    static Configuration at(String original, String evolved) {
        return new Configuration(new State(original), new State(evolved));
    }

    HistoryEntry last() {
        List<HistoryEntry> entries = converter.history();
        return entries.get(entries.size() - 1);
    }

    @Override
    public void close() {
        converter.close();
    }
}
