package org.evoloop.learn;

/**
 * A device cannot be learned, or a file of learning cannot be used; the message says why and what to do.
 *
 * @since 0.1
 */
public final class LearnException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    /** An exception with this message. */
    public LearnException(String message) {
        super(message);
    }

    /** An exception with this message and a cause. */
    public LearnException(String message, Throwable cause) {
        super(message, cause);
    }
}
