package org.evoloop.roomba;

/**
 * Whether the state that the system is in was entered anew because the converter was started again, not because an
 * event led there. Kept by the component that sends, whatever takes its place.
 *
 * <p>Threading: written by one thread at a time, read from any.
 */
final class Resumption {
    private volatile boolean released;
    private volatile boolean resumed;

    /** An event has been dealt with, or the converter is about to be started. */
    void settled() {
        resumed = released;
        released = false;
    }

    /** The converter has been stopped. */
    void released() {
        released = true;
    }

    boolean isResumed() {
        return resumed;
    }
}
