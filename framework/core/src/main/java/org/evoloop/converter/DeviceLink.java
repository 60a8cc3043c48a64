package org.evoloop.converter;

import java.time.Instant;
import java.util.List;
import java.util.Optional;
import org.evoloop.function.Reading;

/**
 * The state of the connection to a device.
 *
 * <p>Threading: called from any thread; must not wait.
 *
 * @since 0.1
 */
public interface DeviceLink {

    /** Whether the device can be reached now. */
    boolean isUp();

    /** The time of day since which the device has been silent; empty while it can be reached, or if unknown. */
    default Optional<Instant> downSince() {
        return Optional.empty();
    }

    /**
     * Current readings of the device, such as its battery; empty if there are none, or while the device cannot be
     * reached. One called {@code error} says what is wrong with the device, in words, or {@code none}.
     */
    default List<Reading> readings() {
        return List.of();
    }

    /** One line for people: where the device is connected, its condition, and any problem. */
    String describe();
}
