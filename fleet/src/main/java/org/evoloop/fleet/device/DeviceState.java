package org.evoloop.fleet.device;

import org.evoloop.engine.Snapshot;
import org.jspecify.annotations.Nullable;

/**
 * The state of a device between two records.
 *
 * <p>Threading: immutable.
 *
 * @param model the version of its models
 * @param sequence the sequence number of its last order
 * @param heard the highest number of an occurrence received from a gateway
 * @param open the order without an answer yet; null if there is none
 * @param lost the last order that was given up, which may still be answered; null if there is none
 * @param snapshot the snapshot of its core
 * @since 0.1
 */
public record DeviceState(
        String model,
        long sequence,
        long heard,
        Order.@Nullable Open open,
        Order.@Nullable Open lost,
        Snapshot snapshot) {}
