package org.evoloop.time;

import java.time.Duration;
import java.util.HashSet;
import java.util.Set;
import org.jspecify.annotations.Nullable;

/**
 * Controls retries, for example of a connection to a device: the pauses grow, and each fault is reported once, until
 * the connection has lasted for {@link #STABLE}.
 *
 * <p>Threading: thread-safe.
 *
 * @since 0.1
 */
public final class Attempts {
    /** The first pause; each further one is twice as long. */
    public static final Duration FIRST = Duration.ofMillis(250);

    /** The longest pause. */
    public static final Duration LONGEST = Duration.ofSeconds(30);

    /**
     * A connection lost sooner counts as another failed attempt: for example, two clients of one name disconnect each
     * other for ever.
     */
    public static final Duration STABLE = Duration.ofSeconds(3);

    private final Set<String> said = new HashSet<>();
    private Duration next = FIRST;
    private @Nullable Long wellSinceNanos;

    /** Creates an instance without attempts so far. */
    public Attempts() {}

    /**
     * The attempt succeeded, or the connection still works.
     *
     * @param nowNanos the time on a monotonic clock
     * @return whether that is news
     */
    public synchronized boolean succeeded(long nowNanos) {
        if (wellSinceNanos != null) {
            return false;
        }
        wellSinceNanos = nowNanos;
        return true;
    }

    /**
     * An attempt has failed, or the connection was lost.
     *
     * @param why the reason, for people
     * @param nowNanos the time on the same clock
     * @return whether {@code why} is news and should be reported
     */
    public synchronized boolean failed(String why, long nowNanos) {
        Long since = wellSinceNanos;
        wellSinceNanos = null;
        if (since != null && nowNanos - since >= STABLE.toNanos()) {
            next = FIRST;
            said.clear();
        }
        return said.add(why);
    }

    /** The pause before the next attempt. */
    public synchronized Duration pause() {
        Duration pause = next;
        Duration twice = pause.multipliedBy(2);
        next = twice.compareTo(LONGEST) > 0 ? LONGEST : twice;
        return pause;
    }
}
