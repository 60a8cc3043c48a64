package org.evoloop.converter.attachment;

import java.util.function.Consumer;
import org.evoloop.evolution.EventOutcome;
import org.evoloop.evolution.Occurrence;

/** Tells whoever reports an occurrence how it ends. */
public interface Endings {
    /**
     * Has {@code then} called once when {@code occurrence} has ended, on a thread that holds no lock of the converter.
     *
     * @throws UnsupportedOperationException if nobody here learns of that
     */
    void await(Occurrence occurrence, Consumer<EventOutcome> then);

    /** {@code occurrence} is not taken, or not any more: who awaits it is told. */
    default void refused(Occurrence occurrence, String why) {}
}
