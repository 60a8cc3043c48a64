package org.evoloop.journal;

/**
 * When the operating system is made to put on the disk what was written. A killed process loses nothing in either case.
 *
 * @since 0.1
 */
public enum Forcing {
    /** At most 100 ms after it was written; a power cut loses at most that. */
    BY_BATCH,
    /** By batch, and before each event is sent to the device; a power cut never lets an event be sent twice. */
    PER_INTENT,
    /** When the operating system sees fit; a power cut loses some 30 s on Linux. */
    NEVER
}
