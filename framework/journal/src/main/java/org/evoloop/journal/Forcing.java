package org.evoloop.journal;

/**
 * When written data is forced to the disk. A killed process loses nothing in any case.
 *
 * @since 0.1
 */
public enum Forcing {
    /** At most 100 ms after it was written; a power cut loses at most that. */
    BY_BATCH,
    /** By batch, and before each event is sent to the device; after a power cut no event is sent twice. */
    PER_INTENT,
    /** When the operating system chooses; a power cut loses some 30 s on Linux. */
    NEVER
}
