package org.evoloop.link;

/**
 * The cable to the device cannot be used. The message is written for the person who plugged it in: it names the port,
 * the fault and how to fix it, and needs no stack trace.
 *
 * @since 0.1
 */
public final class LinkException extends RuntimeException {
    private final Fault fault;

    /** What is wrong. */
    public enum Fault {
        /** The port does not exist, perhaps only until its cable is plugged in. */
        NO_SUCH_PORT,
        /** Another program has the port. */
        BUSY,
        /** The user may not use the port. */
        NO_PERMISSION,
        /** The file is something else. */
        NOT_A_SERIAL_PORT,
        /** The port cannot be set up, for example at a baud rate it does not know. */
        REFUSED,
        /** The cable was pulled, or the program at the other end is gone. */
        HUNG_UP,
        /** The other end takes no more bytes. */
        NOT_READING,
        /** Something else has stopped the device, because this program did not run for a while. */
        OVERRULED,
        /** The link was not opened yet, or {@link Link#close()} ended it. */
        CLOSED
    }

    /** @param message for the person who plugged in the cable, see above */
    public LinkException(Fault fault, String message) {
        super(message);
        this.fault = fault;
    }

    /** What is wrong. */
    public Fault fault() {
        return fault;
    }
}
