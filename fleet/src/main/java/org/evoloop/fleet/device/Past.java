package org.evoloop.fleet.device;

/**
 * What remains of a device that was taken out of the fleet. If it comes back, its numbers continue: its executor skips
 * commands and visits whose numbers it has seen.
 *
 * @param sequence the sequence number of its last order
 * @param visit the number of its last visit
 * @since 0.1
 */
public record Past(long sequence, long visit) {
    /** That of a device that was never in the fleet. */
    public static final Past NONE = new Past(0, 0);

    /** That of a device which is taken out in this state. */
    public static Past of(DeviceState state) {
        return new Past(state.sequence(), state.snapshot().visit().number());
    }
}
