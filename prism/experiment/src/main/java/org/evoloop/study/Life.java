package org.evoloop.study;

import java.nio.file.Path;
import org.evoloop.converter.EventAnalyze;
import org.evoloop.converter.EventExecute;
import org.evoloop.converter.Evolution;
import org.evoloop.converter.PushMonitor;
import org.evoloop.converter.StateKnowledge;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.evolution.Occurrence;
import org.evoloop.journal.Forcing;
import org.evoloop.journal.Journal;
import org.evoloop.loop.LoopConfig;
import org.evoloop.statemachine.State;
import org.jspecify.annotations.Nullable;

/**
 * One process of the converter, from its start until it crashes.
 *
 * <p>Threading: for one thread at a time.
 */
final class Life implements AutoCloseable {
    private static final int SMALL_SEGMENT_BYTES = 1 << 16;

    private final Controller controller = new Controller();
    private final SystemEventConverter converter;
    private int swaps;

    private static final class Controller extends PushMonitor {
        void operate(String event) {
            push(fromController(event));
        }
    }

    /** @param journal where it keeps one; null if it does not */
    Life(LoopConfig config, EventAnalyze analyze, EventExecute execute, @Nullable Path journal) {
        converter = new SystemEventConverter(config);
        converter.addMonitor(controller);
        converter.addAnalyze(analyze);
        converter.addExecute(execute);
        converter.addKnowledge(new StateKnowledge(RingModels.pair(0)));
        if (journal != null) {
            converter.journal(Journal.in(journal)
                    .withSegmentBytes(SMALL_SEGMENT_BYTES)
                    .withKeptBytes(0)
                    .withForcing(Forcing.NEVER));
        }
        converter.build();
        converter.start();
    }

    SystemEventConverter converter() {
        return converter;
    }

    PushMonitor controller() {
        return controller;
    }

    /** An event that finds the queue full is lost, as in the model. */
    void press(int steps) {
        controller.operate(RingModels.event(steps));
    }

    /** The device is seen again, there. */
    void find(String state, long nanos) {
        converter.offer(new Occurrence.Found(new State(state), nanos));
    }

    /** Where the record says that the device is. */
    String record() {
        return converter.status().states().original().name();
    }

    /** Other models take over. */
    void swap() {
        swaps++;
        converter.evolve(Evolution.to(new StateKnowledge(RingModels.pair(swaps % 2))));
    }

    @Override
    public void close() {
        converter.close();
    }
}
