package org.evoloop.roomba.simulator.body;

/**
 * The robot's mechanics. What the firmware sets here takes effect from the next {@link #tick()} on.
 *
 * <p>Figures: measurements of Roomba 500 and 600 robots; currents are plausible means, since only their order of
 * magnitude is documented.
 */
public final class Body {
    /** The robot's firmware works in steps of this length (specification, "Sensors"). */
    public static final int TICK_MILLIS = 15;

    public static final double TICK_SECONDS = TICK_MILLIS / 1000.0;

    private static final int ELECTRONICS_MILLI_AMPS = 200;

    /** How far the front wheel rolls until its light-and-dark sensor changes. */
    private static final double FRONT_WHEEL_STRIPE_MM = 20;

    private final Wheel left = new Wheel();
    private final Wheel right = new Wheel();
    private final Battery battery = new Battery();
    private CleaningMotors cleaningMotors = CleaningMotors.OFF;
    private Pose pose = Pose.ORIGIN;

    /** Sets the velocities that the wheels shall reach; beyond {@link Wheel#FASTEST_MM_PER_S} counts as that. */
    public void drive(double rightMmPerS, double leftMmPerS) {
        right.setTarget(rightMmPerS);
        left.setTarget(leftMmPerS);
    }

    public void setCleaningMotors(CleaningMotors motors) {
        cleaningMotors = motors;
    }

    /** Stops wheels and cleaning motors. */
    public void stop() {
        drive(0, 0);
        setCleaningMotors(CleaningMotors.OFF);
    }

    /** Lets {@value #TICK_MILLIS} ms pass. */
    public void tick() {
        double leftMm = left.tick();
        double rightMm = right.tick();
        pose = pose.rolled(leftMm, rightMm);
        battery.tick(batteryMilliAmps());
    }

    public Wheel left() {
        return left;
    }

    public Wheel right() {
        return right;
    }

    public Battery battery() {
        return battery;
    }

    public CleaningMotors cleaningMotors() {
        return cleaningMotors;
    }

    public Pose pose() {
        return pose;
    }

    /** How far the robot's centre came since it was made; rolling back makes it less. */
    public double travelledMm() {
        return (left.travelledMm() + right.travelledMm()) / 2;
    }

    /** How far the robot turned since it was made, counterclockwise. */
    public double turnedDeg() {
        return Math.toDegrees((right.travelledMm() - left.travelledMm()) / Pose.WHEEL_BASE_MM);
    }

    /** What flows into the battery; negative flows out. */
    public int batteryMilliAmps() {
        return -(ELECTRONICS_MILLI_AMPS
                + left.motorMilliAmps()
                + right.motorMilliAmps()
                + cleaningMotors.mainBrushMilliAmps()
                + cleaningMotors.sideBrushMilliAmps()
                + cleaningMotors.vacuumMilliAmps());
    }

    /** Whether the front wheel's sensor sees its light half; it changes again and again while the robot moves. */
    public boolean frontWheelLight() {
        return ((long) Math.floor(travelledMm() / FRONT_WHEEL_STRIPE_MM) & 1) == 1;
    }
}
