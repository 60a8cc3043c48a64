package org.evoloop.roomba.simulator.body;

/**
 * The robot's battery: 12 cells of nickel metal hydride.
 *
 * @since 0.1
 */
public final class Battery {
    /** The charge of a full battery. */
    public static final int CAPACITY_MILLI_AMP_HOURS = 2696;

    private static final double EMPTY_MILLI_VOLTS = 13_200;
    private static final double FULL_MILLI_VOLTS = 16_400;
    private static final double SECONDS_PER_HOUR = 3600;

    /** Below this share the robot stops cleaning. */
    private static final double LOW_SHARE = 0.1;

    private double chargeMilliAmpHours;

    Battery(int percent) {
        chargeMilliAmpHours = CAPACITY_MILLI_AMP_HOURS * percent / 100.0;
    }

    /**
     * Advances by one tick.
     *
     * @param milliAmps the current into the battery; negative while it discharges
     */
    void tick(int milliAmps) {
        double change = milliAmps * Body.TICK_SECONDS / SECONDS_PER_HOUR;
        chargeMilliAmpHours = Math.max(0, Math.min(CAPACITY_MILLI_AMP_HOURS, chargeMilliAmpHours + change));
    }

    /** The battery's charge. */
    public int chargeMilliAmpHours() {
        return (int) Math.round(chargeMilliAmpHours);
    }

    /** How full the battery is, 0 to 100. */
    public int percent() {
        return (int) Math.round(100 * share());
    }

    private double share() {
        return chargeMilliAmpHours / CAPACITY_MILLI_AMP_HOURS;
    }

    /** Whether it is full. */
    public boolean isFull() {
        return share() == 1;
    }

    /** Whether it is time to look for the dock. */
    public boolean isLow() {
        return share() < LOW_SHARE;
    }

    /** Whether it is empty. */
    public boolean isEmpty() {
        return chargeMilliAmpHours == 0;
    }

    /** The voltage, which falls with the charge. */
    public int milliVolts() {
        return (int) Math.round(EMPTY_MILLI_VOLTS + (FULL_MILLI_VOLTS - EMPTY_MILLI_VOLTS) * share());
    }
}
