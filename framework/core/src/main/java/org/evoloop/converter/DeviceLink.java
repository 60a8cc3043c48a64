package org.evoloop.converter;

import java.time.Instant;
import java.util.List;
import java.util.Optional;
import org.evoloop.function.Reading;

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

    /** What is known of the device now, such as its battery; empty if nothing is, or while the device cannot be reached. */
    default List<Reading> readings() {
        return List.of();
    }

    /** One line for people: where it is connected, how it is, what is wrong. */
    String describe();
}
