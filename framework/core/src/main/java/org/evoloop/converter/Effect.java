package org.evoloop.converter;

import org.evoloop.evolution.Values;

/**
 * A behavior that the new model names on its transitions, see {@link StateKnowledge#effect}.
 *
 * <p>Threading: run on the thread of the execute component that carries the transition out.
 *
 * @since 0.1
 */
@FunctionalInterface
public interface Effect {

    /**
     * Runs the effect; returns when it is done.
     *
     * @throws InterruptedException if the thread is interrupted meanwhile
     * @throws Exception any failure: it is reported, and the event has failed although the transition is taken
     */
    void run() throws Exception;

    /** An effect that uses the event's values. */
    @FunctionalInterface
    interface OfEvent {
        /** Runs the effect; see {@link Effect#run}. */
        void run(Values values) throws Exception;
    }
}
