package org.evoloop.fleet.device;

import org.evoloop.core.Snapshot;
import org.jspecify.annotations.Nullable;

/**
 * All that is known of a device between two records.
 *
 * <p>Threading: immutable.
 *
 * @param model the version of its models
 * @param sequence that of its last order
 * @param heard the number of the last occurrence that a gateway has numbered
 * @param open the order that was not answered yet; null if there is none
 * @param lost the last order that was given up, which may be answered after all; null if there is none
 * @param snapshot of its core
 * @since 0.1
 */
public record Kept(
        String model,
        long sequence,
        long heard,
        Order.@Nullable Open open,
        Order.@Nullable Open lost,
        Snapshot snapshot) {}
