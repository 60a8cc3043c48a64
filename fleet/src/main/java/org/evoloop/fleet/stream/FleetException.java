package org.evoloop.fleet.stream;

/**
 * A problem with a fleet, described for the person who can fix it.
 *
 * @since 0.1
 */
public final class FleetException extends RuntimeException {
    /** @param message the problem, and how to fix it */
    public FleetException(String message) {
        super(message);
    }
}
