package org.evoloop.payload.report;

import java.util.function.Consumer;
import org.evoloop.time.Clock;

/**
 * A device that reports its state from one source or several, such as topics.
 *
 * <p>Threading: set up by one thread, before the connection is opened; consumers are called one at a time.
 *
 * @since 0.1
 */
public interface ReportingDevice {
    /** Measures limits and pauses. */
    Clock clock();

    /** Those in which its reports are heard. */
    Turns turns();

    /** Whether it can be reached. */
    boolean isUp();

    /** What is wrong if it cannot be reached. */
    String describe();

    /** Passes on each report of a source to {@code consumer}, before those that are there. */
    void subscribeFirst(String source, Consumer<Report> consumer);

    /** What is known of commands to the device that reports its state from this source: the same each time. */
    Aftermath aftermath(String source);

    /** Sets an action for each time that the device is lost; it receives what is wrong. */
    void onLost(Consumer<String> action);
}
