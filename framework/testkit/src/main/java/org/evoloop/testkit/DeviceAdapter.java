package org.evoloop.testkit;

import org.evoloop.converter.EventExecute;
import org.evoloop.converter.EventMonitor;

/**
 * What somebody has written to connect a device with a converter, for an {@link OrderCheck}.
 *
 * @param monitor tells what the device does by itself
 * @param execute sends it commands
 * @param close ends what the adapter has begun, such as threads of its own
 * @since 0.1
 */
public record DeviceAdapter(EventMonitor monitor, EventExecute execute, Runnable close) {

    /** One that has nothing to end. */
    public DeviceAdapter(EventMonitor monitor, EventExecute execute) {
        this(monitor, execute, () -> {});
    }
}
