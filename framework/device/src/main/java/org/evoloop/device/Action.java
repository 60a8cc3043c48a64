package org.evoloop.device;

import java.time.Duration;

/**
 * One thing that a function of a device file does.
 *
 * <p>Threading: immutable.
 */
sealed interface Action {
    /** Sends an event to the device; the new model stays in its state. */
    record Send(String event) implements Action {}

    /** Raises an event, and goes on. */
    record Raise(String event) implements Action {}

    /** Ends the function with an event. */
    record Finish(String event) implements Action {}

    /** Goes on later. */
    record Wait(Duration time) implements Action {}

    /** Writes into the transcript. */
    record Say(String text) implements Action {}

    /**
     * Does something outside of the converter.
     *
     * @param what for messages
     */
    record Do(String what, Outward outward) implements Action {}
}
