package org.evoloop.converter;

import static org.evoloop.Machines.machine;

import java.time.Duration;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CountDownLatch;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Step;
import org.evoloop.function.Visit;
import org.evoloop.loop.LoopConfig;
import org.evoloop.loop.ThreadingModel;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;

/** A lamp whose converter has one faulty component; everything else works. */
final class Faulty implements AutoCloseable {

    /** The components that can be faulty. */
    enum Part {
        MONITOR,
        ANALYZE,
        PLAN,
        EXECUTE,
        GUARD,
        EFFECT,
        FUNCTION,
        TASK,
        SETTLED,
        RELEASED,
        END_OF_VISIT,
        LISTENER
    }

    /** What the faulty component does. */
    interface Fault {
        /** Returns what the component returns; null for nothing. */
        @Nullable
        Object show() throws Exception;
    }

    final PushMonitor wallSwitch = new PushMonitor("Switch");
    final SystemEventConverter converter;
    private final Part part;
    private final Fault fault;
    private final CountDownLatch dim = new CountDownLatch(1);
    private volatile boolean healthy;

    Faulty(Part part, ThreadingModel threading, Clock clock, Duration join, Fault fault) {
        this.part = part;
        this.fault = fault;
        converter = new SystemEventConverter(LoopConfig.defaults("faulty", clock)
                .withThreading(threading)
                .withStepLimit(LiveRobot.STEP_LIMIT)
                .withJoinLimit(join));
        converter.addMonitor(wallSwitch);
        if (part == Part.MONITOR) {
            converter.addMonitor(new Ear());
        }
        converter.addAnalyze(new Brain("Brain"));
        converter.addPlan(new Will("Will"));
        converter.addExecute(new Lamp("Lamp"));
        converter.addSpare("NewBrain", () -> new Brain("NewBrain"));
        converter.addSpare("NewWill", () -> new Will("NewWill"));
        converter.addSpare("NewLamp", () -> new Lamp("NewLamp"));
        converter.addSpare("NewEar", Ear::new);
        converter.addKnowledge(new Rooms());
        converter.addListener(new ConverterListener() {
            @Override
            public void ended(HistoryEntry entry) {
                inTask(Part.LISTENER);
            }
        });
        converter.build();
    }

    /** Presses the switch; when this returns, the function of the state Dim has set its timer. */
    void press(String event) throws InterruptedException {
        wallSwitch.press(event);
        if (event.equals("dim") && !healthy) {
            LiveRobot.await(dim);
        }
    }

    /** Removes the fault. */
    void heals() {
        healthy = true;
    }

    private @Nullable Object at(Part here) throws Exception {
        return here == part && !healthy ? fault.show() : this;
    }

    private @Nullable Object inTask(Part here) {
        try {
            return at(here);
        } catch (RuntimeException | Error thrown) {
            throw thrown;
        } catch (Exception thrown) {
            throw new IllegalStateException(thrown.getMessage(), thrown);
        }
    }

    private final class Ear extends EventMonitor {
        private final CountDownLatch never = new CountDownLatch(1);

        Ear() {
            super("Ear");
        }

        @Override
        protected @Nullable Occurrence getEvent() throws Exception {
            Object observed = at(Part.MONITOR);
            if (observed == Faulty.this) {
                never.await();
            }
            return observed == null ? null : fromDevice(observed.toString());
        }
    }

    private final class Brain extends EventAnalyze {
        Brain(String name) {
            super(name);
        }

        @Override
        protected @Nullable Analysis analyze(Occurrence occurrence) {
            return inTask(Part.ANALYZE) == null ? null : super.analyze(occurrence);
        }
    }

    private final class Will extends EventPlan {
        Will(String name) {
            super(name);
        }

        @Override
        protected @Nullable ChangePlan plan(Analysis analysis) {
            return inTask(Part.PLAN) == null ? null : super.plan(analysis);
        }
    }

    private final class Lamp extends EventExecute {
        Lamp(String name) {
            super(name);
        }

        @Override
        protected Set<String> sendableEvents() {
            return Set.of("press");
        }

        @Override
        protected void send(Step step) throws Exception {
            at(Part.EXECUTE);
        }

        @Override
        protected Optional<String> locate() {
            return Optional.of("Off");
        }

        @Override
        protected void settled(Configuration now) throws Exception {
            at(Part.SETTLED);
        }

        @Override
        protected void released() throws Exception {
            at(Part.RELEASED);
        }
    }

    private final class Rooms extends StateKnowledge {
        Rooms() {
            super(new ModelPair(
                    machine("original", "Off press -> On", "On press -> Off"),
                    machine(
                            "new",
                            "Off press [dark] -> On / beep",
                            "Off press -> On",
                            "On press -> Off",
                            "Off dim -> Dim",
                            "Dim press -> On",
                            "Dim dim -> Off")));
        }

        @Override
        protected void registerNewFunctions() {
            guard("dark", () -> {
                inTask(Part.GUARD);
                return true;
            });
            effect("beep", () -> inTask(Part.EFFECT));
            function("Dim", this::dim);
        }

        private void dim(Visit visit) throws Exception {
            visit.onEnd(() -> inTask(Part.END_OF_VISIT));
            visit.after(Duration.ofMillis(1), () -> inTask(Part.TASK));
            dim.countDown();
            at(Part.FUNCTION);
        }
    }

    @Override
    public void close() {
        converter.close();
    }
}
