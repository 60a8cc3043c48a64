package org.evoloop.converter.binding;

import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.BiConsumer;
import java.util.function.Predicate;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Values;
import org.evoloop.loop.Failure;
import org.evoloop.loop.LoopConfig;
import org.evoloop.time.Clock;

/**
 * Watches one guard: counts its exceptions, and keeps other threads out while it hangs. Monitors of the device evaluate
 * guards on their own threads, and each of them would hang too.
 *
 * <p>Threading: thread-safe.
 */
final class GuardWatch {
    private final String text;
    private final Clock clock;
    private final long limitNanos;
    private final BiConsumer<String, Failure<Occurrence>> failures;
    private final AtomicInteger asked = new AtomicInteger();

    /** When a call last returned, or the first of the present calls began. */
    private volatile long movedNanos;

    GuardWatch(String text, LoopConfig config, BiConsumer<String, Failure<Occurrence>> failures) {
        this.text = text;
        this.clock = config.clock();
        this.limitNanos = config.stepLimit().toNanos();
        this.failures = failures;
    }

    /** Whether it is being evaluated now. */
    boolean isAsked() {
        return asked.get() > 0;
    }

    /**
     * Evaluates it.
     *
     * @param counts whether an exception counts as a failure
     * @throws IllegalStateException if it has hung in another thread for longer than the step limit
     */
    boolean test(Predicate<Values> condition, Values values, boolean counts) {
        long now = clock.nanoTime();
        if (isAsked() && now - movedNanos > limitNanos) {
            throw new IllegalStateException("guard [" + text + "] has not returned for " + limitNanos / 1_000_000
                    + " ms in another thread, and is not called again until it does");
        }
        // Before it counts as asked: another thread would take it to have hung since it was asked last.
        if (!isAsked()) {
            movedNanos = now;
        }
        asked.getAndIncrement();
        try {
            return condition.test(values);
        } catch (RuntimeException | Error cause) {
            if (counts) {
                failures.accept("guard [" + text + "]", new Failure<>("guard", text, 0, null, cause));
            }
            throw cause;
        } finally {
            movedNanos = clock.nanoTime();
            asked.getAndDecrement();
        }
    }
}
