package org.evoloop.converter;

import java.time.Duration;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Occurrence;
import org.evoloop.loop.Failure;

/**
 * Is notified of what a converter does, see {@link SystemEventConverter#addListener}.
 *
 * <p>Threading: called on one thread of the converter that does nothing else, one call at a time and in the order in
 * which things happened; in a converter without threads after each step, on the thread that takes it. One that throws
 * is logged.
 *
 * @since 0.1
 */
public interface ConverterListener {
    /** One that only hears what has {@link #ended}. */
    static ConverterListener onEnded(Consumer<HistoryEntry> then) {
        return new ConverterListener() {
            @Override
            public void ended(HistoryEntry entry) {
                then.accept(entry);
            }
        };
    }

    /** One that only hears what has {@link #moved}; {@code then} gets the states before and after. */
    static ConverterListener onMoved(BiConsumer<Configuration, Configuration> then) {
        return new ConverterListener() {
            @Override
            public void moved(Configuration before, Configuration after) {
                then.accept(before, after);
            }
        };
    }

    /** One that only hears what has {@link #failed}. */
    static ConverterListener onFailed(Consumer<Failure<Occurrence>> then) {
        return new ConverterListener() {
            @Override
            public void failed(Failure<Occurrence> failure) {
                then.accept(failure);
            }
        };
    }

    /**
     * The conversion time of an occurrence, from its observation to its decision. Called right before {@link #ended};
     * not for an occurrence whose plan broke off.
     */
    default void converted(Duration waited) {}

    /** An occurrence has ended with this result. */
    default void ended(HistoryEntry entry) {}

    /** The current states have changed. */
    default void moved(Configuration before, Configuration after) {}

    /** Other models have taken over; later notices are in terms of these. */
    default void evolved(Evolution.Result result) {}

    /** A component has failed, or a guard, an effect, a new function or one of its tasks. */
    default void failed(Failure<Occurrence> failure) {}

    /** Whether the record of the device is in doubt has changed; {@code why} is empty if it no longer is. */
    default void doubted(String why) {}
}
