package org.evoloop.models;

import java.time.Duration;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.Supplier;

/** Work that ends in good order when the process is told to end, as by Ctrl-C: its thread is interrupted, and waited for. */
final class Interruptible {
    private static final Duration PATIENCE = Duration.ofMinutes(1);

    private Interruptible() {}

    static <T> T call(Supplier<T> work) {
        Thread worker = Thread.currentThread();
        CountDownLatch ended = new CountDownLatch(1);
        Thread hook = new Thread(() -> end(worker, ended), "end");
        Runtime.getRuntime().addShutdownHook(hook);
        try {
            return work.get();
        } finally {
            ended.countDown();
            try {
                Runtime.getRuntime().removeShutdownHook(hook);
            } catch (IllegalStateException ending) {
                // The hook has been called.
            }
        }
    }

    private static void end(Thread worker, CountDownLatch ended) {
        worker.interrupt();
        try {
            if (!ended.await(PATIENCE.toMillis(), TimeUnit.MILLISECONDS)) {
                System.err.println("learning has not ended within " + PATIENCE.toSeconds() + " s");
            }
        } catch (InterruptedException impatient) {
            Thread.currentThread().interrupt();
        }
    }
}
