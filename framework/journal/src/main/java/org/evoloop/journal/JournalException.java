package org.evoloop.journal;

/**
 * A journal that cannot be read, written or gone on with. The message names the file, the place in it and what to do; it
 * needs no stack trace.
 *
 * @since 0.1
 */
public final class JournalException extends RuntimeException {
    /** @param message for people */
    public JournalException(String message) {
        super(message);
    }

    JournalException(String message, Throwable cause) {
        super(message, cause);
    }
}
