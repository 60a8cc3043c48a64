package org.evoloop.core;

import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.ModelPair;
import org.evoloop.statemachine.Event;
import org.jspecify.annotations.Nullable;

/**
 * Watches a core's inputs and the states to which they lead, over time, and finds violations.
 *
 * <p>Times are nanoseconds of the converter's monotonic clock. Threading: called by one thread at a time, under a lock; it must
 * return at once.
 *
 * @since 0.1
 */
public interface Sentry {
    /** As {@link #dueNanos} if nothing is awaited. */
    long NEVER = Long.MAX_VALUE;

    /** Posts a sentry where models begin to run. */
    @FunctionalInterface
    interface Posting {
        /**
         * The sentry that watches these models from now on; null for none.
         *
         * @param at where device and evolved system are
         */
        @Nullable
        Sentry post(ModelPair models, Configuration at, long atNanos);
    }

    /**
     * A violation that was found.
     *
     * @param property the name of what is violated
     * @param raised the event that follows from it; null if none does
     */
    record Violation(String property, @Nullable Event raised) {}

    /** An event comes; nothing has become of it yet. */
    void comes(Event event, Configuration at, long atNanos);

    /** Device or evolved system stand elsewhere. */
    void moved(Configuration at, long atNanos);

    /** When it has to be told that time has {@link #passed}, unless something else happens before; {@link #NEVER} if not. */
    long dueNanos();

    /** It is this late. */
    void passed(long atNanos);

    /** A violation that was found and not reported yet; null if there is none. */
    @Nullable
    Violation poll();
}
