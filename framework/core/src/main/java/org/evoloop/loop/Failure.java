package org.evoloop.loop;

import org.jspecify.annotations.Nullable;

/**
 * A component failed. The loop goes on.
 *
 * <p>Threading: immutable.
 *
 * @param component its name
 * @param phase what it was doing, such as {@code getEvent} or {@code execute}
 * @param cycle the number of the cycle, 0 outside of one
 * @param occurrence what it was working on, null if nothing
 * @param cause what it threw, or what was found wrong with it
 * @param <O> an occurrence
 * @since 0.1
 */
public record Failure<O>(
        String component,
        String phase,
        long cycle,
        @Nullable O occurrence,
        Throwable cause) {

    /** For messages: {@code Lamp.execute: no answer}. */
    @Override
    public String toString() {
        String message = cause.getMessage();
        return component + "." + phase + ": "
                + (message == null ? cause.getClass().getSimpleName() : message);
    }
}
