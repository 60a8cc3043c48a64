package org.evoloop.statemachine;

/**
 * A model cannot be used as it is. The message is written for the person who drew it: it names what is wrong, where,
 * and how to fix it, and needs no stack trace.
 *
 * @since 0.1
 */
public final class ModelException extends RuntimeException {

    /** @param message for the user, see above */
    public ModelException(String message) {
        super(message);
    }

    /** @param message for the user; includes what the user needs to know of {@code cause}, thrown by a library */
    public ModelException(String message, Throwable cause) {
        super(message, cause);
    }
}
