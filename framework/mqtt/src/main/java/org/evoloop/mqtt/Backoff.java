package org.evoloop.mqtt;

import java.time.Duration;

/**
 * How long is waited before the next attempt: twice as long as before the last one, from {@link #FIRST} to {@link #LONGEST}.
 *
 * <p>Threading: not thread-safe.
 */
final class Backoff {
    static final Duration FIRST = Duration.ofMillis(250);
    static final Duration LONGEST = Duration.ofSeconds(30);

    private Duration next = FIRST;

    /** The wait before the next attempt. */
    Duration next() {
        Duration wait = next;
        Duration twice = wait.multipliedBy(2);
        next = twice.compareTo(LONGEST) > 0 ? LONGEST : twice;
        return wait;
    }

    /** An attempt was successful. */
    void reset() {
        next = FIRST;
    }
}
