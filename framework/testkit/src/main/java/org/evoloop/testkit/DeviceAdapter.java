package org.evoloop.testkit;

import org.evoloop.converter.EventExecute;
import org.evoloop.converter.EventMonitor;

/**
 * The code that connects a device to a converter, for an {@link OrderCheck}.
 *
 * @param monitor reports what the device does by itself
 * @param execute sends it commands
 * @param close ends what the adapter has started, such as its own threads
 * @since 0.1
 */
public record DeviceAdapter(EventMonitor monitor, EventExecute execute, Runnable close) {

    /** An adapter with nothing to end. */
    public DeviceAdapter(EventMonitor monitor, EventExecute execute) {
        this(monitor, execute, () -> {});
    }
}
