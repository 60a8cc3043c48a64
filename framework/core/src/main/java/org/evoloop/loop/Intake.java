package org.evoloop.loop;

import org.jspecify.annotations.Nullable;

/**
 * The queue of a loop, which also decides which occurrences are taken.
 *
 * <p>Threading: guarded by the loop's lock, but for {@link #atOnce}; nothing in it may wait.
 *
 * @param <O> an occurrence
 * @since 0.1
 */
public interface Intake<O> {

    /** The result of offering an occurrence. */
    enum Admission {
        /** It waits for its turn, or has already ended. */
        TAKEN,
        /** The loop is closed. */
        REFUSED,
        /** The loop cannot record it. */
        NOT_RECORDED,
        /** There was no room, for the first time since there was last room. */
        FIRST_DROPPED,
        /** There was no room again. */
        DROPPED
    }

    /**
     * An answer that needs no lock, for monitors that report more than there is room for; null if there is none. Called
     * from any thread.
     */
    default @Nullable Admission atOnce(O occurrence) {
        return null;
    }

    /** Takes or refuses an occurrence. */
    Admission offer(O occurrence);

    /** Whether there is room for an occurrence whose source waits until there is, see {@link MapeLoop#put}. */
    boolean hasRoom(O occurrence);

    /** The occurrence that has its turn now; null if none has. */
    @Nullable
    O next();

    /** The occurrence that had its turn has ended, in whatever way. */
    void ended();

    /** The loop is open from now on. */
    void opened();

    /** The loop is closed from now on. */
    void closed();

    /** How many wait and how many were lost. */
    QueueStatus status();
}
