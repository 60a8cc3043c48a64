package org.evoloop.payload;

import java.time.Duration;
import java.util.Optional;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;

/**
 * Tells whether what messages mean has held for a time, such as the power of a machine that only pauses.
 *
 * <p>Threading: thread-safe.
 *
 * @since 0.1
 */
public final class Steady {
    private final Clock clock;
    private final Duration lasting;
    private @Nullable String held;
    private long sinceNanos;

    /** @param lasting how long a meaning must hold to count; zero if it counts at once */
    public Steady(Clock clock, Duration lasting) {
        this.clock = clock;
        this.lasting = Clock.requireDelay(lasting);
    }

    /** A message came; without a meaning it ends the one that was held. */
    public synchronized void see(Optional<Meanings.Meaning> now) {
        String name = now.map(Meanings.Meaning::name).orElse(null);
        if (name == null || !name.equals(held)) {
            held = name;
            sinceNanos = clock.nanoTime();
        }
    }

    /** Whether this is what the messages mean, and has been for long enough. */
    public synchronized boolean counts(Meanings.Meaning meaning) {
        return meaning.name().equals(held) && leftNanos() <= 0;
    }

    /** Whether the messages mean something else. */
    public synchronized boolean isOther(Meanings.Meaning meaning) {
        return held != null && !held.equals(meaning.name());
    }

    /** How long the meaning of the newest message must still hold. */
    public synchronized Duration left() {
        return Duration.ofNanos(Math.max(0, leftNanos()));
    }

    private long leftNanos() {
        return lasting.toNanos() - (clock.nanoTime() - sinceNanos);
    }
}
