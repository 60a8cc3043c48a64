package org.evoloop.time;

import java.time.Duration;
import java.util.HashSet;
import java.util.Set;
import org.jspecify.annotations.Nullable;

/**
 * How something that fails is tried again, such as connecting to a device: after longer and longer pauses, and with each
 * fault reported once, until the connection has lasted for {@link #STABLE}.
 *
 * <p>Threading: thread-safe.
 *
 * @since 0.1
 */
public final class Attempts {
    /** The first pause; each is twice as long as the one before. */
    public static final Duration FIRST = Duration.ofMillis(250);

    /** No pause is longer. */
    public static final Duration LONGEST = Duration.ofSeconds(30);

    /** What is lost sooner counts as one more failed attempt: two clients of one name drop each other for ever. */
    public static final Duration STABLE = Duration.ofSeconds(3);

    private final Set<String> said = new HashSet<>();
    private Duration next = FIRST;
    private @Nullable Long wellSinceNanos;

    /** Nothing has been tried yet. */
    public Attempts() {}

    /**
     * All is well.
     *
     * @param nowNanos by a monotonic clock
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
     * An attempt has failed, or what was well is over.
     *
     * @param why for people
     * @param nowNanos by the same clock
     * @return whether {@code why} is news, and to be reported
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
