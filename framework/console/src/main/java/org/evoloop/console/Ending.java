package org.evoloop.console;

import org.jspecify.annotations.Nullable;

/**
 * The request for a console to end: its reason and status.
 *
 * <p>Threading: any thread may request it; {@link #begin}, {@link #await} and {@link #over} are for the console's
 * thread, which is interrupted by the first request, but not after it has begun to close things.
 */
final class Ending {
    private @Nullable Thread console;
    private @Nullable String reason;
    private int status;

    /** The caller's thread runs the console. */
    synchronized void begin() {
        console = Thread.currentThread();
        if (reason != null) {
            console.interrupt();
        }
    }

    /** Only the first reason counts. */
    synchronized void ask(String why, int exitStatus) {
        if (reason == null) {
            reason = why;
            status = exitStatus;
            notifyAll();
            if (console != null && console != Thread.currentThread()) {
                console.interrupt();
            }
        }
    }

    synchronized boolean isAsked() {
        return reason != null;
    }

    synchronized void await() throws InterruptedException {
        while (reason == null) {
            wait();
        }
    }

    /** From here on, no request interrupts the closing; a pending interrupt is cleared. */
    synchronized void over() {
        console = null;
        Thread.interrupted();
    }

    synchronized String reason() {
        return reason == null ? "a failure" : reason;
    }

    synchronized int status() {
        return status;
    }
}
