package org.evoloop.study;

/**
 * What makes the loop of a {@link Bench} work.
 *
 * <p>Threading: {@link #settle} is called by whoever uses the bench, the others where it happens.
 */
interface LoopDriver {

    /** Has the loop deal with everything that it has, and with what comes meanwhile. */
    void settle();

    /** A control of the controller was operated. */
    void pressed();

    /** An event has been handed over. */
    void dealtWith();
}
