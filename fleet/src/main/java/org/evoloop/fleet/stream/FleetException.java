package org.evoloop.fleet.stream;

/**
 * A problem with a fleet, described for the person who can fix it.
 *
 * @since 0.1
 */
public class FleetException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    /** @param message the problem, and how to fix it */
    public FleetException(String message) {
        super(message);
    }
}
