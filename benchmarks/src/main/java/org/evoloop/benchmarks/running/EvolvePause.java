package org.evoloop.benchmarks.running;

import java.io.IOException;
import java.util.List;
import java.util.Set;
import org.HdrHistogram.Histogram;
import org.evoloop.benchmarks.report.Latencies;
import org.evoloop.benchmarks.report.TemporaryFolder;
import org.evoloop.converter.EventExecute;
import org.evoloop.converter.Evolution;
import org.evoloop.converter.PushMonitor;
import org.evoloop.converter.StateKnowledge;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Step;
import org.evoloop.function.NewFunction;
import org.evoloop.journal.Journal;
import org.evoloop.loop.LoopConfig;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.StateMachineBuilder;
import org.evoloop.time.SystemClock;
import org.jspecify.annotations.Nullable;

/**
 * How long no event can start while a converter at work swaps between two models of {@value #STATES} states; without a
 * journal and with one.
 */
public final class EvolvePause {
    private static final int STATES = 10_000;
    private static final int WARM_UP = 30;

    private EvolvePause() {}

    private static final class Device extends EventExecute {
        @Override
        protected Set<String> sendableEvents() {
            return Set.of("next", "back");
        }

        @Override
        protected void send(Step step) {}
    }

    private static final class Ring extends StateKnowledge {
        Ring(ModelPair models) {
            super(models);
        }

        @Override
        protected void registerNewFunctions() {
            if (models().evolved().hasState(new State("Rest"))) {
                function("Rest", NewFunction.none());
            }
        }
    }

    /**
     * Prints medians and 99th percentiles in microseconds.
     *
     * @param arguments the number of swaps
     */
    public static void main(String[] arguments) throws IOException {
        int times = Integer.parseInt(arguments[0]);
        Latencies.print("PLAIN", pauses(times, null));
        try (TemporaryFolder journal = TemporaryFolder.create()) {
            Latencies.print("JOURNAL", pauses(times, Journal.in(journal.path())));
        }
    }

    private static Histogram pauses(int times, @Nullable Journal journal) {
        ModelPair small = ring(false);
        ModelPair large = ring(true);
        PushMonitor monitor = new PushMonitor("Buttons");
        Histogram pauses = Latencies.histogram();
        try (SystemEventConverter converter =
                new SystemEventConverter(LoopConfig.defaults("ring", new SystemClock()))) {
            converter.addMonitor(monitor);
            converter.addExecute(new Device());
            converter.addKnowledge(new Ring(small));
            if (journal != null) {
                converter.journal(journal);
            }
            converter.build();
            converter.start();
            for (int swap = 0; swap < WARM_UP + times; swap++) {
                monitor.press("next");
                Evolution.Result result = converter.evolve(Evolution.to(new Ring(swap % 2 == 0 ? large : small)));
                if (swap >= WARM_UP) {
                    pauses.recordValue(result.pause().toNanos());
                }
            }
        }
        return pauses;
    }

    private static ModelPair ring(boolean larger) {
        StateMachineBuilder original = StateMachine.named("original").initial("S0");
        StateMachineBuilder evolved =
                StateMachine.named(larger ? "larger" : "new").initial("S0");
        for (int state = 0; state < STATES; state++) {
            for (StateMachineBuilder machine : List.of(original, evolved)) {
                machine.transition("S" + state, "next", "S" + (state + 1) % STATES);
                machine.transition("S" + state, "back", "S" + (state + STATES - 1) % STATES);
            }
        }
        if (larger) {
            evolved.transition("S0", "rest", "Rest").transition("Rest", "next", "S1");
        }
        return new ModelPair(original.build(), evolved.build());
    }
}
