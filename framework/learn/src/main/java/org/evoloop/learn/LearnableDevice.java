package org.evoloop.learn;

import java.time.Duration;

/**
 * A device that is being learned. Each method returns when the device is quiet.
 *
 * <p>A device that does not answer within a limit of the implementation's own is reported as unanswered or, if nothing can
 * go on, with a {@link LearnException}; no method waits for ever.
 *
 * <p>Threading: called on the thread that learns.
 *
 * @since 0.1
 */
public interface LearnableDevice {
    /**
     * Brings the device into its first state.
     *
     * @throws LearnException if this cannot be done
     * @throws InterruptedException if the thread is interrupted
     */
    Heard reset() throws InterruptedException;

    /**
     * Presses an input.
     *
     * @throws LearnException if the device cannot be reached
     * @throws InterruptedException if the thread is interrupted
     */
    Heard press(String input) throws InterruptedException;

    /**
     * Waits until the device has done something by itself and is quiet again, or {@code longest} has passed.
     *
     * @return an answer whose reply is {@link Answer.Reply#WAITED}; without acts, and showing what was shown before, if
     *     nothing happened
     * @throws LearnException if the device cannot be reached
     * @throws InterruptedException if the thread is interrupted
     */
    Heard await(Duration longest) throws InterruptedException;

    /**
     * An answer, and when it began.
     *
     * @param answer the answer
     * @param firstNanos the time of its first sign, on the clock of the learning
     */
    record Heard(Answer answer, long firstNanos) {}
}
