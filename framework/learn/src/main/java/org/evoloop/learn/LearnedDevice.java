package org.evoloop.learn;

import java.time.Duration;
import java.util.Map;

/**
 * A device that is operated so as to learn it. An implementation listens after each input until the device is quiet.
 *
 * <p>Threading: used by one thread, which may be interrupted.
 *
 * @since 0.1
 */
public interface LearnedDevice {
    /** The input that lets time pass; no event has this name. */
    String WAIT = "";

    /**
     * Brings the device to where every word begins.
     *
     * @throws LostException if it could not be brought there
     */
    Heard reset() throws InterruptedException;

    /**
     * Sends an event.
     *
     * @throws DisturbedException if a person or the device itself acted before the event was sent
     * @throws LostException if the device is gone
     */
    Heard press(String event) throws InterruptedException;

    /**
     * Sends nothing until the device does something by itself.
     *
     * @param longest how long at most
     * @throws DisturbedException if a person acted
     * @throws LostException if the device is gone
     */
    Heard await(Duration longest) throws InterruptedException;

    /** How many events were ever sent to it, those of resets included. */
    int sent();

    /** What it measures now, by name. */
    default Map<String, Double> readings() {
        return Map.of();
    }

    /** What was heard does not count: somebody else acted. The word is repeated. */
    final class DisturbedException extends RuntimeException {
        private static final long serialVersionUID = 1;

        /**
         * @param message what happened
         */
        public DisturbedException(String message) {
            super(message);
        }
    }

    /** The device does not answer, or could not be reset. */
    final class LostException extends RuntimeException {
        private static final long serialVersionUID = 1;

        /**
         * @param message what happened, and what a person can do
         */
        public LostException(String message) {
            super(message);
        }
    }
}
