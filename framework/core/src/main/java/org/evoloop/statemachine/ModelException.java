package org.evoloop.statemachine;

/**
 * A model cannot be used as it is. The message is written for the person who drew it: it names what is wrong, where,
 * and how to fix it, and needs no stack trace.
 */
public final class ModelException extends RuntimeException {

    public ModelException(String message) {
        super(message);
    }

    public ModelException(String message, Throwable cause) {
        super(message, cause);
    }
}
