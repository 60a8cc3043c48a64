package org.evoloop.roomba.simulator.body;

/** The robot's battery: 12 cells of nickel metal hydride. */
public final class Battery {
    public static final int CAPACITY_MILLI_AMP_HOURS = 2696;

    private static final double EMPTY_MILLI_VOLTS = 13_200;
    private static final double FULL_MILLI_VOLTS = 16_400;
    private static final double SECONDS_PER_HOUR = 3600;

    private double chargeMilliAmpHours = CAPACITY_MILLI_AMP_HOURS;

    /**
     * Lets a tick pass.
     *
     * @param milliAmps negative flows out
     */
    void tick(int milliAmps) {
        double change = milliAmps * Body.TICK_SECONDS / SECONDS_PER_HOUR;
        chargeMilliAmpHours = Math.max(0, Math.min(CAPACITY_MILLI_AMP_HOURS, chargeMilliAmpHours + change));
    }

    public int chargeMilliAmpHours() {
        return (int) Math.round(chargeMilliAmpHours);
    }

    public int milliVolts() {
        double full = chargeMilliAmpHours / CAPACITY_MILLI_AMP_HOURS;
        return (int) Math.round(EMPTY_MILLI_VOLTS + (FULL_MILLI_VOLTS - EMPTY_MILLI_VOLTS) * full);
    }
}
