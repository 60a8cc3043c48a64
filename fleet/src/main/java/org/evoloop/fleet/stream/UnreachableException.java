package org.evoloop.fleet.stream;

/**
 * No broker answers.
 *
 * @since 0.1
 */
public final class UnreachableException extends FleetException {
    private static final long serialVersionUID = 1L;

    /** @param message names the broker, and how to fix it */
    public UnreachableException(String message) {
        super(message);
    }
}
