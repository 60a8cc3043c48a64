package org.evoloop.converter;

/**
 * What is to be known of the connection to a device.
 *
 * <p>Threading: called from any thread; must not wait.
 */
public interface DeviceLink {

    /** Whether the device can be reached now. */
    boolean isUp();

    /** One line for people: where it is connected, how it is, what is wrong. */
    String describe();
}
