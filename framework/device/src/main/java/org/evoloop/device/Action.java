package org.evoloop.device;

import java.time.Duration;
import java.util.function.Consumer;
import org.evoloop.evolution.Values;

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
     * @param to where
     * @param what for messages
     */
    record Do(Connection to, String what, Outward outward) implements Action {
        /** Does it; if the connection is only played, {@code played} is told instead. */
        void perform(Values values, Consumer<String> played) throws Exception {
            if (to.isPlayed()) {
                played.accept(what);
            } else {
                outward.perform(values);
            }
        }
    }
}
