package org.evoloop.roomba;

/**
 * Whether the current state was entered again because the converter was restarted, not because of an event. Updated by
 * the component that sends commands; the value stays when that component is replaced.
 *
 * <p>Threading: written by one thread at a time, read from any.
 */
final class Resumption {
    private volatile boolean released;
    private volatile boolean resumed;

    /** An event has been handled, or the converter is about to be started. */
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
