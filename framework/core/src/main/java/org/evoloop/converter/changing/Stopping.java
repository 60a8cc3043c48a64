package org.evoloop.converter.changing;

import java.time.Duration;
import org.evoloop.time.Threads;
import org.jspecify.annotations.Nullable;

/**
 * Finishes the stop of a converter on a thread of its own, so that the caller of {@code stop} gets an answer soon,
 * whatever hangs.
 *
 * <p>Threading: thread-safe.
 */
final class Stopping {
    /** How long {@code stop} waits. */
    static final long ANSWER_MILLIS = 100;

    /** Everything it waits for has its own limit; this one only guards against a mistake in those. */
    private static final Duration LONGEST = Duration.ofMinutes(5);

    private final String name;
    private @Nullable Thread thread;

    /** Whether it is to be done once more: the converter may have been started again after it was last done. */
    private boolean again;

    /** @param name the converter's */
    Stopping(String name) {
        this.name = name;
    }

    /**
     * Runs {@code rest}; if it is already running, once more after that.
     *
     * @param atOnce whether to return without waiting for it
     * @return whether it has finished
     */
    boolean begin(Runnable rest, boolean atOnce) {
        Thread doing;
        synchronized (this) {
            doing = thread;
            if (doing == null || !doing.isAlive()) {
                again = false;
                doing = new Thread(() -> work(rest), "converter-" + name + "-stop");
                doing.setDaemon(true);
                thread = doing;
                doing.start();
            } else {
                again = true;
            }
        }
        return !atOnce && Threads.join(doing, Duration.ofMillis(ANSWER_MILLIS));
    }

    private void work(Runnable rest) {
        do {
            rest.run();
        } while (isWantedAgain());
    }

    /** If not, the next stop begins a thread of its own, although this one may still be alive for a moment. */
    private synchronized boolean isWantedAgain() {
        boolean wanted = again;
        again = false;
        thread = wanted ? thread : null;
        return wanted;
    }

    /**
     * Waits until it has finished.
     *
     * @param fromWithin whether it would wait for the caller
     * @throws IllegalStateException if that would take for ever
     */
    void await(boolean fromWithin) {
        Thread doing;
        synchronized (this) {
            doing = thread;
        }
        if (doing == null || doing == Thread.currentThread() || !doing.isAlive()) {
            return;
        }
        if (fromWithin) {
            throw new IllegalStateException("the converter " + name + " is still being stopped");
        }
        Threads.join(doing, LONGEST);
    }
}
