package org.evoloop.models;

import java.util.function.Supplier;
import org.evoloop.console.TerminationSignals;

/**
 * Work that ends in good order when the process is told to end, as by Ctrl-C: its thread is interrupted, and nothing else
 * happens, so that what it works with stays open until it has ended.
 */
final class Interruptible {
    private Interruptible() {}

    static <T> T call(Supplier<T> work) {
        Thread worker = Thread.currentThread();
        TerminationSignals signals = new TerminationSignals(signal -> worker.interrupt());
        try {
            return work.get();
        } finally {
            signals.restore();
            // What is left to do is ended in good order, too.
            Thread.interrupted();
        }
    }
}
