package org.evoloop.converter;

import java.time.Instant;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import java.util.function.Supplier;
import org.evoloop.engine.Core;
import org.evoloop.engine.Inputs;
import org.evoloop.engine.Outputs;
import org.evoloop.engine.Rules;
import org.evoloop.engine.Snapshot;
import org.evoloop.evolution.ModelPair;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;

/**
 * Records a converter's inputs, so that a converter of the same models can continue where the previous process ended;
 * see {@link SystemEventConverter#journal}.
 *
 * <p>Threading: belongs to one converter, which calls it one call at a time.
 *
 * @since 0.1
 */
public interface ConverterJournal {

    /** Receives the replayed outputs of a core. */
    interface Past extends Outputs {
        /**
         * Sets how the outputs that follow are dated: by {@code time}, and by {@code nanos} on the clock of the
         * occurrences.
         */
        void at(Supplier<Instant> time, LongSupplier nanos);
    }

    /**
     * The models to which the converter of this journal, built with {@code models}, has evolved; null if it has not.
     * Called before the journal is opened.
     *
     * @throws RuntimeException if it cannot be read; the message says why and what to do
     */
    @Nullable
    ModelPair evolvedFrom(ModelPair models);

    /**
     * Opens this journal for one converter.
     *
     * @param rules the rules of that converter
     * @param clock the clock of the times in the result
     * @param past receives the core's outputs from the part of the journal that is read
     * @return the converter's last state; null if nothing has been recorded yet
     * @throws RuntimeException if it cannot be continued; the message says why and what to do
     */
    @Nullable
    Snapshot open(Rules rules, Clock clock, Past past);

    /**
     * Starts recording the inputs of {@code core}.
     *
     * @param failed receives the cause when recording has stopped
     * @param works called when it continues after that
     * @return receives the inputs from now on, and passes them to {@code core} once they are recorded. While recording
     *     is impossible, it refuses the events of controllers, and throws instead of announcing a step or an effect
     * @throws RuntimeException if it cannot be written; the message says why and what to do
     */
    Inputs keep(Core core, Consumer<Exception> failed, Runnable works);

    /**
     * Called when other models are about to take over: writes in advance what can be written, so that the takeover need
     * not wait for it. It has no effect unless they do take over.
     *
     * @param rules the converter's rules after the takeover
     * @throws RuntimeException if it cannot be written; the message says why and what to do
     */
    void prepare(Rules rules);

    /**
     * Replays the whole journal, oldest entry first; takes some seconds if it is large. May be called on any thread,
     * also while inputs are being recorded.
     *
     * @param rules the rules of this journal's converter
     * @param past receives the core's outputs
     * @throws RuntimeException if it cannot be read; the message says why and what to do
     */
    void replay(Rules rules, Past past);

    /** Stops recording. Idempotent. */
    void close();
}
