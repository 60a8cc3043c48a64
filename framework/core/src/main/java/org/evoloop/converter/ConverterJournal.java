package org.evoloop.converter;

import java.time.Instant;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import java.util.function.Supplier;
import org.evoloop.core.Core;
import org.evoloop.core.Inputs;
import org.evoloop.core.Outputs;
import org.evoloop.core.Rules;
import org.evoloop.core.Snapshot;
import org.evoloop.evolution.ModelPair;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;

/**
 * What keeps a converter's inputs, so that a converter of the same models can go on where another process has ended; see
 * {@link SystemEventConverter#journal}.
 *
 * <p>Threading: belongs to one converter, which calls it one call at a time.
 *
 * @since 0.1
 */
public interface ConverterJournal {

    /** Who hears again what a core has said. */
    interface Past extends Outputs {
        /** From now on {@code time} tells when that was, and {@code nanos} the same on the clock of the occurrences. */
        void at(Supplier<Instant> time, LongSupplier nanos);
    }

    /**
     * The models to which a converter has evolved that was built with {@code models}, and whose journal this is; null if it
     * has not. Called before it is opened.
     *
     * @throws RuntimeException if it cannot be read; the message says why and what to do
     */
    @Nullable
    ModelPair evolvedFrom(ModelPair models);

    /**
     * Opens it for one converter.
     *
     * @param rules of the converter that opens it
     * @param clock whose times the answer has
     * @param past hears what the core said in the part of the past that is looked through
     * @return where the converter stood; null if nothing has been kept yet
     * @throws RuntimeException if it cannot be gone on with; the message says why and what to do
     */
    @Nullable
    Snapshot open(Rules rules, Clock clock, Past past);

    /**
     * Begins to record the inputs of {@code core}.
     *
     * @param failed hears that nothing is kept any more, and why
     * @return takes the inputs from now on, and passes them to {@code core} once they are recorded. While nothing can be kept, it
     *     refuses the events of controllers, and throws instead of announcing a step or an effect
     * @throws RuntimeException if it cannot be written; the message says why and what to do
     */
    Inputs keep(Core core, Consumer<Exception> failed);

    /**
     * Other models are about to take over: what can be written beforehand is written, so that they need not wait for it.
     * Nothing counts of it unless they do.
     *
     * @param rules by which the converter goes then
     * @throws RuntimeException if it cannot be written; the message says why and what to do
     */
    void prepare(Rules rules);

    /**
     * Tells again all that is kept, the oldest first; takes some seconds if that is much. May be called on any thread, also
     * while inputs are being kept.
     *
     * @param rules of the converter that keeps it
     * @param past hears what the core said
     * @throws RuntimeException if it cannot be read; the message says why and what to do
     */
    void retell(Rules rules, Past past);

    /** Nothing more is kept. Idempotent. */
    void close();
}
