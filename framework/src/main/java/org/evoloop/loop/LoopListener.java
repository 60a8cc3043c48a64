package org.evoloop.loop;

/**
 * Hears what goes wrong in a loop: the one channel for failures.
 *
 * <p>Threading: called on whichever thread found out. Methods must be quick and must not throw.
 *
 * @param <O> an occurrence
 */
public interface LoopListener<O> {

    /** A component failed; if it was in a cycle, that cycle has ended without effect from there on. */
    void failed(Failure<O> failure);

    /**
     * The queue was full and {@code occurrence} is lost.
     *
     * @param first whether this is the first loss since there was room
     */
    void dropped(O occurrence, boolean first);
}
