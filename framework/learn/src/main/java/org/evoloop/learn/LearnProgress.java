package org.evoloop.learn;

import java.time.Duration;

/**
 * Told how far learning is.
 *
 * <p>Threading: called by the thread that learns; must be short.
 *
 * @since 0.1
 */
@FunctionalInterface
public interface LearnProgress {
    /**
     * A word was answered by the device, or a hypothesis was made.
     *
     * @param states how many states are known
     * @param words how many words the device was given
     * @param elapsed since learning began
     */
    void at(int states, int words, Duration elapsed);
}
