package org.evoloop.study;

/**
 * What makes the loop of a {@link Bench} work.
 *
 * <p>Threading: {@link #settle} is called by the user of the bench, the other methods on the thread where things happen.
 */
interface LoopDriver {

    /** Has the loop deal with everything that it has, and with what comes meanwhile. */
    void settle();

    /** A control of the controller was operated. */
    void pressed();

    /** An event has been handed over. */
    void dealtWith();
}
