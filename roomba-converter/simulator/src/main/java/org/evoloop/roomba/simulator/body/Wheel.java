package org.evoloop.roomba.simulator.body;

/**
 * A driven wheel with its motor and encoder. Forward is positive.
 *
 * @since 0.1
 */
public final class Wheel {
    /** The highest speed in the specification. */
    public static final double FASTEST_MM_PER_S = 500;

    private static final double DIAMETER_MM = 72.0;
    private static final double COUNTS_PER_REVOLUTION = 508.8;

    /** How far the wheel rolls from one count of its encoder to the next, 0.4446 mm. */
    public static final double MM_PER_COUNT = Math.PI * DIAMETER_MM / COUNTS_PER_REVOLUTION;

    /** The resolution of the speed controller (specification, "Drive"). */
    private static final double SPEED_STEP_MM_PER_S = 28.5;

    /** Chosen so that a robot accelerating from rest to 200 mm/s covers 187 mm in the first second, as iRobot measured. */
    private static final double SPEED_CHANGE_PER_TICK_MM_PER_S = 1600 * Body.TICK_SECONDS;

    private static final double TURNING_MILLI_AMPS = 60;
    private static final double MILLI_AMPS_PER_MM_PER_S = 0.5;

    private double targetMmPerS;
    private double velocityMmPerS;
    private double travelledMm;

    /** At rest. */
    public Wheel() {}

    /** Sets the target, rounded to the controller's resolution, but never to zero unless it is zero. */
    void setTarget(double mmPerS) {
        double steps = Math.max(1, Math.rint(Math.abs(mmPerS) / SPEED_STEP_MM_PER_S));
        targetMmPerS = Math.signum(mmPerS) * Math.min(steps * SPEED_STEP_MM_PER_S, FASTEST_MM_PER_S);
    }

    /** Advances by one tick; returns how far the wheel rolled in it. */
    double tick() {
        double before = velocityMmPerS;
        double wanted = targetMmPerS - before;
        velocityMmPerS += Math.signum(wanted) * Math.min(Math.abs(wanted), SPEED_CHANGE_PER_TICK_MM_PER_S);
        double rolledMm = (before + velocityMmPerS) / 2 * Body.TICK_SECONDS;
        travelledMm += rolledMm;
        return rolledMm;
    }

    /** How fast it rolls; negative is backwards. */
    public double velocityMmPerS() {
        return velocityMmPerS;
    }

    /** The distance rolled since the wheel was created; rolling backwards reduces it. */
    public double travelledMm() {
        return travelledMm;
    }

    /** The encoder's counts since the wheel was created; rolling backwards reduces them. */
    public long counts() {
        return (long) Math.floor(travelledMm / MM_PER_COUNT);
    }

    /** What its motor draws. */
    public int motorMilliAmps() {
        double speed = Math.abs(velocityMmPerS);
        return speed == 0 ? 0 : (int) (TURNING_MILLI_AMPS + MILLI_AMPS_PER_MM_PER_S * speed);
    }
}
