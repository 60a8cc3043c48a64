package org.evoloop.fleet.device;

import org.evoloop.core.Output;

/**
 * Receives the results of a {@link Device}, in order.
 *
 * @since 0.1
 */
public interface DeviceListener {
    /** Somebody has to do this. */
    void ordered(Order order);

    /** A notice about an occurrence, the record or the models. */
    void noted(Output.Notice notice);

    /**
     * All that followed from one thing has been told, and this is how the device is left.
     *
     * @param isNew whether the evolved system is in a state that only the new model has
     */
    void settled(DeviceState kept, boolean isNew);
}
