package org.evoloop.testkit;

/**
 * What a device says on its {@link DeviceLine}, in the order in which it happened.
 *
 * <p>Threading: immutable.
 *
 * @since 0.1
 */
public sealed interface DeviceReport {

    /** What happened, an event of the original model. */
    String event();

    /** Where the device is after that. */
    String state();

    /** It has done {@code event} by itself. */
    record Acted(String event, String state) implements DeviceReport {}

    /** It has taken the command {@code event}, which means nothing in some states and then changes nothing. */
    record Took(String event, String state) implements DeviceReport {}
}
