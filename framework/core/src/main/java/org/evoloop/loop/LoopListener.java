package org.evoloop.loop;

/**
 * Hears what goes wrong in a loop: the one channel for failures.
 *
 * <p>Threading: called on whichever thread found out. Methods must be quick and must not throw.
 *
 * @param <O> an occurrence
 * @since 0.1
 */
public interface LoopListener<O> {

    /** A component failed; if it was in a cycle, that cycle has ended without effect from there on. */
    void failed(Failure<O> failure);

    /**
     * A component did not return in time, or was exchanged before it did: what it was working on has ended for the loop.
     * It is unknown whether it still had its effect on the world outside.
     */
    default void givenUp(Failure<O> failure) {
        failed(failure);
    }

    /**
     * The queue was full and {@code occurrence} is lost.
     *
     * @param first whether this is the first loss since there was room
     */
    void dropped(O occurrence, boolean first);

    /**
     * Analyze or plan has returned null, so the occurrence is ignored. In one loop that is how it is told that nothing has to be
     * done, in another it should be rare.
     *
     * @param role as it is shown, such as {@code analyze}
     * @param inARow how often it has returned nothing else until now, from 1
     */
    default void returnedNull(String component, String role, int inARow) {}
}
