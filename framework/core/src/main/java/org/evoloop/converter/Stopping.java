package org.evoloop.converter;

import java.time.Duration;
import org.evoloop.time.Threads;
import org.jspecify.annotations.Nullable;

/**
 * What follows when a converter was stopped, on a thread of its own: the caller of {@code stop} gets an answer soon, whatever
 * hangs.
 *
 * <p>Threading: thread-safe.
 */
final class Stopping {
    /** So long somebody who stops the converter waits. */
    static final long ANSWER_MILLIS = 100;

    /** All that it waits for has limits; this is only so that no mistake in them lasts for ever. */
    private static final Duration LONGEST = Duration.ofMinutes(5);

    private final String name;
    private @Nullable Thread thread;

    /** @param name the converter's */
    Stopping(String name) {
        this.name = name;
    }

    /**
     * Has {@code rest} done, unless that is under way.
     *
     * @param atOnce whether not to wait for it
     * @return whether it was done
     */
    boolean begin(Runnable rest, boolean atOnce) {
        Thread doing;
        synchronized (this) {
            doing = thread;
            if (doing == null || !doing.isAlive()) {
                doing = new Thread(rest, "converter-" + name + "-stop");
                doing.setDaemon(true);
                thread = doing;
                doing.start();
            }
        }
        return !atOnce && Threads.join(doing, Duration.ofMillis(ANSWER_MILLIS));
    }

    /**
     * Waits until nothing of it is under way.
     *
     * @param fromWithin whether the caller is one for whom it waits
     * @throws IllegalStateException if that would be for ever
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
