package org.evoloop.http;

import java.io.IOException;
import java.time.Instant;
import java.time.ZoneId;
import java.time.format.DateTimeFormatter;
import java.util.Locale;
import java.util.Optional;
import org.jspecify.annotations.Nullable;

/**
 * How the newest attempt to reach a device went.
 *
 * <p>Threading: thread-safe.
 */
final class Health {
    private static final DateTimeFormatter SECOND = DateTimeFormatter.ofPattern("uuuu-MM-dd HH:mm:ss", Locale.ROOT);

    private final String place;
    private String trouble;
    private @Nullable Instant reached;
    private @Nullable Instant downSince = Instant.now();
    private long attempts;
    private long judged;
    private int patience;
    private int misses;

    /**
     * @param place the device's address, for messages
     * @param patience how many attempts in a row must fail until the device counts as gone
     */
    Health(String place, int patience) {
        this.place = place;
        patience(patience);
        this.trouble = place + " has not been reached yet";
    }

    /** Sets how many attempts in a row must fail. */
    final synchronized void patience(int attemptsInARow) {
        if (attemptsInARow < 1) {
            throw new IllegalArgumentException(
                    place + " cannot be gone after " + attemptsInARow + " unanswered questions; give at least 1");
        }
        patience = attemptsInARow;
    }

    /** An attempt. */
    @FunctionalInterface
    interface Attempt<T> {
        T run() throws IOException, InterruptedException;
    }

    /** Makes an attempt and remembers how it went. */
    <T> T noting(Attempt<T> attempt) throws IOException, InterruptedException {
        long number = begin();
        try {
            T result = attempt.run();
            ended(number, "");
            return result;
        } catch (IOException failure) {
            ended(number, String.valueOf(failure.getMessage()));
            throw failure;
        }
    }

    private synchronized long begin() {
        return ++attempts;
    }

    /** One that began earlier and took longer says nothing new. */
    private synchronized void ended(long number, String wrong) {
        if (number < judged) {
            return;
        }
        judged = number;
        misses = wrong.isEmpty() ? 0 : misses + 1;
        if (misses > 0 && misses < patience && trouble.isEmpty()) {
            return;
        }
        trouble = wrong;
        if (wrong.isEmpty()) {
            reached = Instant.now();
            downSince = null;
        } else if (downSince == null) {
            downSince = Instant.now();
        }
    }

    synchronized boolean isUp() {
        return trouble.isEmpty();
    }

    synchronized Optional<Instant> downSince() {
        return Optional.ofNullable(downSince);
    }

    /** What is wrong, or when the device was last reached: it may have gone since. */
    synchronized String describe() {
        Instant last = reached;
        return trouble.isEmpty() && last != null
                ? place + " reached at " + SECOND.format(last.atZone(ZoneId.systemDefault()))
                : trouble;
    }
}
