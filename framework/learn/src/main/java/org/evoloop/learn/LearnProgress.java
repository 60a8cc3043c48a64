package org.evoloop.learn;

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
     * @param soFar the best machine so far; it is open until learning ends
     * @param expected how many words the test of that machine takes at most from here on, if the device passes it
     */
    void at(Learned soFar, int expected);
}
