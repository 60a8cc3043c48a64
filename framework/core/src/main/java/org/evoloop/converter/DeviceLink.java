package org.evoloop.converter;

import java.time.Instant;
import java.util.Optional;

/**
 * What is to be known of the connection to a device.
 *
 * <p>Threading: called from any thread; must not wait.
 *
 * @since 0.1
 */
public interface DeviceLink {

    /** Whether the device can be reached now. */
    boolean isUp();

    /** Since when nothing has been heard of the device, by the time of day; empty while it can be reached, or if not known. */
    default Optional<Instant> downSince() {
        return Optional.empty();
    }

    /** One line for people: where it is connected, how it is, what is wrong. */
    String describe();
}
