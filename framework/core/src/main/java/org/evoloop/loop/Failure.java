package org.evoloop.loop;

import org.jspecify.annotations.Nullable;

/**
 * A component failed. The loop continues.
 *
 * <p>Threading: immutable.
 *
 * @param component its name
 * @param phase what it was doing, such as {@code getEvent} or {@code execute}
 * @param cycle the number of the cycle, 0 outside of one
 * @param occurrence the occurrence that it was working on; null if none
 * @param cause the exception that it threw, or one that describes the problem found
 * @param <O> an occurrence
 * @since 0.1
 */
public record Failure<O>(
        String component,
        String phase,
        long cycle,
        @Nullable O occurrence,
        Throwable cause) {
    private static final int LONGEST = 1000;

    /** For messages: {@code Lamp.execute: no answer}. */
    @Override
    public String toString() {
        return component + "." + phase + ": " + message();
    }

    /** The exception is user code: its message may be missing, be huge, or throw itself. */
    private String message() {
        String message;
        try {
            message = cause.getMessage();
        } catch (RuntimeException bad) {
            message = null;
        }
        if (message == null) {
            return cause.getClass().getSimpleName();
        }
        return message.length() <= LONGEST ? message : message.substring(0, LONGEST) + "...";
    }
}
