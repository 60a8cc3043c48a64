package org.evoloop.converter.attachment;

import java.util.function.Consumer;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Outcome;
import org.jspecify.annotations.Nullable;

/** Tells a monitor how an occurrence that it reports ends. */
public interface Endings {
    /**
     * How an occurrence has ended.
     *
     * @param before null if the converter did not take it, as the next two
     * @param decision null if it was not decided, or its plan broke off
     */
    record Ended(
            @Nullable Configuration before,
            @Nullable Configuration after,
            @Nullable Outcome outcome,
            @Nullable Decision decision,
            String detail) {}

    /**
     * Has {@code then} called once when {@code occurrence} has ended, on a thread that holds no lock of the converter.
     *
     * @throws UnsupportedOperationException if nobody here learns of that
     */
    void await(Occurrence occurrence, Consumer<Ended> then);
}
