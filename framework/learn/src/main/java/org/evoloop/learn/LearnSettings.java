package org.evoloop.learn;

import java.time.Duration;

/**
 * How a device is learned.
 *
 * <p>Threading: immutable.
 *
 * @param longest how long a state is observed for what the device does by itself
 * @param budget when learning ends with the best machine so far
 * @param depth how many states more than found the test looks for
 * @since 0.1
 */
public record LearnSettings(Duration longest, Duration budget, int depth) {
    /** A minute for each state, a day in all. */
    public static final LearnSettings USUAL = new LearnSettings(Duration.ofMinutes(1), Duration.ofDays(1), 1);

    public LearnSettings {
        if (longest.isNegative() || longest.isZero() || budget.isNegative() || budget.isZero() || depth < 0) {
            throw new IllegalArgumentException("times must be positive, and the depth not negative");
        }
    }
}
