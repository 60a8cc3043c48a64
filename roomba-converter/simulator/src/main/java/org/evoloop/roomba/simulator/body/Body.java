package org.evoloop.roomba.simulator.body;

import org.evoloop.roomba.simulator.room.Marker;
import org.evoloop.roomba.simulator.room.Pose;
import org.evoloop.roomba.simulator.room.Room;

/**
 * The robot's mechanics. Settings by the firmware take effect at the next {@link #tick()}.
 *
 * <p>Figures: measurements of Roomba 500 and 600 robots; currents are plausible means, since only their order of
 * magnitude is documented.
 *
 * @since 0.1
 */
public final class Body {
    /** The robot's firmware works in steps of this length (specification, "Sensors"). */
    public static final int TICK_MILLIS = 15;

    /** {@link #TICK_MILLIS} in seconds. */
    public static final double TICK_SECONDS = TICK_MILLIS / 1000.0;

    private static final int ELECTRONICS_MILLI_AMPS = 200;

    /** The current of the electronics while the robot sleeps. */
    private static final int SLEEPING_MILLI_AMPS = 5;

    private static final int CHARGING_MILLI_AMPS = 1_000;
    private static final int TRICKLE_MILLI_AMPS = 50;

    /** How far the front wheel rolls until its light-and-dark sensor changes. */
    private static final double FRONT_WHEEL_STRIPE_MM = 20;

    private final Wheel left = new Wheel();
    private final Wheel right = new Wheel();
    private final Battery battery;
    private CleaningMotors cleaningMotors = CleaningMotors.OFF;
    private Room room;
    private Pose pose;
    private double progressMm;
    private boolean lifted;
    private boolean awake = true;
    private boolean chargerAllowed = true;

    /**
     * A robot at the start of a room.
     *
     * @param batteryPercent how full the battery is, 0 to 100
     */
    public Body(Room room, int batteryPercent) {
        this.room = room;
        this.pose = room.start();
        this.battery = new Battery(batteryPercent);
    }

    /** Sets the wheels' target velocities, limited to {@link Wheel#FASTEST_MM_PER_S}. */
    public void drive(double rightMmPerS, double leftMmPerS) {
        right.setTarget(rightMmPerS);
        left.setTarget(leftMmPerS);
    }

    /** Powers the cleaning motors. */
    public void setCleaningMotors(CleaningMotors motors) {
        cleaningMotors = motors;
    }

    /** Stops wheels and cleaning motors. */
    public void stop() {
        drive(0, 0);
        setCleaningMotors(CleaningMotors.OFF);
    }

    /** Advances by {@value #TICK_MILLIS} ms. */
    public void tick() {
        double leftMm = left.tick();
        double rightMm = right.tick();
        // With a wheel in the air the robot rests on its underside, or is being held.
        if (surroundings().wheelDrops().isEmpty()) {
            Pose before = pose;
            pose = room.moved(before, before.rolled(leftMm, rightMm));
            double movedMm = before.distanceMmTo(pose.center());
            progressMm += Math.abs(before.bearingRadTo(pose.xMm(), pose.yMm())) < Math.PI / 2 ? movedMm : -movedMm;
        }
        battery.tick(batteryMilliAmps());
    }

    /** Moves the robot to another pose. */
    public void place(Pose where) {
        pose = where;
    }

    /** Lifts the robot, or sets it down where it was. */
    public void setLifted(boolean inTheAir) {
        lifted = inTheAir;
    }

    /** Moves the dock to another pose. */
    public void moveDock(Pose where) {
        room = room.withDock(where);
    }

    /** Moves, covers or uncovers the marker. */
    public void setMarker(Marker marker) {
        room = room.withMarker(marker);
    }

    /** Sets whether the electronics are awake. */
    public void setAwake(boolean atWork) {
        awake = atWork;
    }

    /** Sets whether the battery may be charged on the dock. */
    public void allowCharger(boolean allowed) {
        chargerAllowed = allowed;
    }

    /** Whether the battery is being charged; the dock always has power. */
    public boolean isCharging() {
        return chargerAllowed && surroundings().docked();
    }

    /** The room in which the robot is. */
    public Room room() {
        return room;
    }

    /** The robot's current surroundings. */
    public Surroundings surroundings() {
        return new Surroundings(room, pose, lifted);
    }

    /** The left wheel. */
    public Wheel left() {
        return left;
    }

    /** The right wheel. */
    public Wheel right() {
        return right;
    }

    /** Its battery. */
    public Battery battery() {
        return battery;
    }

    /** How the cleaning motors are powered. */
    public CleaningMotors cleaningMotors() {
        return cleaningMotors;
    }

    /** The robot's position and heading. */
    public Pose pose() {
        return pose;
    }

    /** The distance driven since the robot was created; driving backwards reduces it. */
    public double travelledMm() {
        return (left.travelledMm() + right.travelledMm()) / 2;
    }

    /** The angle turned by its wheels since the robot was created, counterclockwise. */
    public double turnedDeg() {
        return Math.toDegrees((right.travelledMm() - left.travelledMm()) / Pose.WHEEL_BASE_MM);
    }

    /** Whether the robot drives forward, or turns within less than its own radius; not straight or widely back. */
    public boolean isMovingForwardOrTightly() {
        double sum = left.velocityMmPerS() + right.velocityMmPerS();
        double difference = right.velocityMmPerS() - left.velocityMmPerS();
        double radiusMm = Math.abs(Pose.WHEEL_BASE_MM / 2 * sum / difference);
        return sum > 0 || radiusMm < Room.ROBOT_RADIUS_MM;
    }

    /** The current into the battery; negative while it discharges. */
    public int batteryMilliAmps() {
        if (isCharging()) {
            return battery.isFull() ? TRICKLE_MILLI_AMPS : CHARGING_MILLI_AMPS;
        }
        return -((awake ? ELECTRONICS_MILLI_AMPS : SLEEPING_MILLI_AMPS)
                + left.motorMilliAmps()
                + right.motorMilliAmps()
                + cleaningMotors.mainBrushMilliAmps()
                + cleaningMotors.sideBrushMilliAmps()
                + cleaningMotors.vacuumMilliAmps());
    }

    /** Whether the front wheel's sensor sees its light half; it changes again and again while the robot moves. */
    public boolean frontWheelLight() {
        return ((long) Math.floor(progressMm / FRONT_WHEEL_STRIPE_MM) & 1) == 1;
    }
}
