package org.evoloop.testkit;

/**
 * A report of a device on its {@link DeviceLine}, in the order of events at the device.
 *
 * <p>Threading: immutable.
 *
 * @since 0.1
 */
public sealed interface DeviceReport {

    /** The event, of the original model. */
    String event();

    /** The device's state after it. */
    String state();

    /** It has done {@code event} by itself. */
    record Acted(String event, String state) implements DeviceReport {}

    /** It has taken the command {@code event}, which has no effect in states without a transition for it. */
    record Took(String event, String state) implements DeviceReport {}
}
