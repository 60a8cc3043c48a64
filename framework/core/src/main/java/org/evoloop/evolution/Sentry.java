package org.evoloop.evolution;

import org.evoloop.statemachine.Event;
import org.jspecify.annotations.Nullable;

/**
 * Watches a core's inputs and the states to which they lead, over time, and finds violations.
 *
 * <p>Times are nanoseconds of the converter's monotonic clock. Threading: called by one thread at a time, under a lock;
 * it must return at once.
 *
 * @since 0.1
 */
public interface Sentry {
    /** The value of {@link #dueNanos} if there is no deadline. */
    long NEVER = Long.MAX_VALUE;

    /** Creates a sentry when models begin to run. */
    @FunctionalInterface
    interface Posting {
        /**
         * The sentry that watches these models from now on; null for none.
         *
         * @param at the states of device and evolved system
         */
        @Nullable
        Sentry post(ModelPair models, Configuration at, long atNanos);
    }

    /**
     * A violation.
     *
     * @param property the name of the violated property
     * @param raised the event that follows from it; null if none does
     */
    record Violation(String property, @Nullable Event raised) {}

    /** An event comes; it has not been handled yet. */
    void comes(Event event, Configuration at, long atNanos);

    /** The state of device or evolved system has changed. */
    void moved(Configuration at, long atNanos);

    /**
     * When {@link #passed} has to be called, unless something else happens before; {@link #NEVER} if there is no
     * deadline.
     */
    long dueNanos();

    /** Time has passed. */
    void passed(long atNanos);

    /** Removes and returns a violation not yet reported; null if there is none. */
    @Nullable
    Violation poll();
}
