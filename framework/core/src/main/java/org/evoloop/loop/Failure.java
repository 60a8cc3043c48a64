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
    private static final int LONGEST = 1000;

    /** For messages: {@code Lamp.execute: no answer}. */
    @Override
    public String toString() {
        return component + "." + phase + ": " + message();
    }

    /** What was thrown is not ours: its message may be missing, as long as a book, or throw by itself. */
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
