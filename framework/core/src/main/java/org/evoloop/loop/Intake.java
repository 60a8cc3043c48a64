package org.evoloop.loop;

import org.jspecify.annotations.Nullable;

/**
 * Where the occurrences of a loop wait for their turn, and what decides which of them are taken.
 *
 * <p>Threading: guarded by the loop's lock, but for {@link #atOnce}; nothing in it may wait.
 *
 * @param <O> an occurrence
 * @since 0.1
 */
public interface Intake<O> {

    /** What became of an occurrence that was offered. */
    enum Admission {
        /** It waits for its turn, or has come to its end already. */
        TAKEN,
        /** The loop is closed. */
        REFUSED,
        /** There was no room, for the first time since there was some. */
        FIRST_DROPPED,
        /** There was no room, once more. */
        DROPPED
    }

    /**
     * An answer that needs no lock, for monitors that report more than there is room for; null if there is none. Called from
     * any thread.
     */
    default @Nullable Admission atOnce(O occurrence) {
        return null;
    }

    /** Takes an occurrence, or does not. */
    Admission offer(O occurrence);

    /** Whether one more occurrence would be taken. */
    boolean hasRoom();

    /** The occurrence that has its turn now; null if none has. */
    @Nullable
    O next();

    /** The one that had its turn has come to its end, whatever that was. */
    void ended();

    /** The loop is open from now on. */
    void opened();

    /** The loop is closed from now on. */
    void closed();

    /** What waits and what was lost. */
    QueueStatus status();
}
