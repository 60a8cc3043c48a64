package org.evoloop.fleet.stream;

/**
 * That something of a fleet is not as it has to be, in words for whoever can mend it.
 *
 * @since 0.1
 */
public final class FleetException extends RuntimeException {
    /** @param message names what is wrong, and how to mend it */
    public FleetException(String message) {
        super(message);
    }
}
