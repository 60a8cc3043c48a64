package org.evoloop.console;

import org.jspecify.annotations.Nullable;

/**
 * Whether, why and with which status a console shall end.
 *
 * <p>Threading: asked for from any thread; {@link #begin}, {@link #await} and {@link #over} belong to the console's,
 * which is interrupted by the first who asks, and by nobody once it closes what it has to close.
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

    /** What is closed from here on is closed in peace: an interrupt that asked for the end has been answered. */
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
