package org.evoloop.loop;

/**
 * Is notified of everything that goes wrong in a loop: the one channel for failures.
 *
 * <p>Threading: called on whichever thread detected the failure. Methods must be quick and must not throw.
 *
 * @param <O> an occurrence
 * @since 0.1
 */
public interface LoopListener<O> {

    /** A component failed; if it was in a cycle, that cycle has ended without effect from there on. */
    void failed(Failure<O> failure);

    /**
     * A component did not return in time, or was exchanged before it did: its work has ended for the loop. It is
     * unknown whether it still had its effect outside.
     */
    default void givenUp(Failure<O> failure) {
        failed(failure);
    }

    /**
     * The queue was full and {@code occurrence} is lost.
     *
     * @param first whether this is the first loss since there was last room
     */
    void dropped(O occurrence, boolean first);

    /**
     * Analyze or plan has returned null, so {@code about} is ignored. In some loops that is normal when nothing has to
     * be done, in others it should be rare. Called on the thread that has the turn.
     *
     * @param role the role as displayed, such as {@code analyze}
     * @param inARow how many times in a row it has returned null, from 1
     */
    default void returnedNull(String component, String role, int inARow, O about) {}
}
