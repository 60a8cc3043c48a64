package org.evoloop.fleet.device;

import org.evoloop.engine.Output;

/**
 * Receives the results of a {@link Device}, in order.
 *
 * @since 0.1
 */
public interface DeviceListener {
    /** An order to be carried out at the device. */
    void ordered(Order order);

    /** How an occurrence ended, whether the record is in doubt, or that other models have taken over. */
    void noted(Output.Notice notice);

    /**
     * All results of one input have been reported; {@code state} is the device's state after it.
     *
     * @param isNew whether the evolved system is in a state that only the new model has
     */
    void settled(DeviceState state, boolean isNew);
}
