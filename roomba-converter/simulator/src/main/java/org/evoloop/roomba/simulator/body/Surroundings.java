package org.evoloop.roomba.simulator.body;

import java.util.EnumSet;
import java.util.Set;
import org.evoloop.roomba.simulator.room.Point;
import org.evoloop.roomba.simulator.room.Pose;
import org.evoloop.roomba.simulator.room.Room;

/**
 * What the robot's sensors detect in the room, also when it is lifted.
 *
 * <p>Threading: immutable; everything is computed when it is requested.
 *
 * @since 0.1
 */
public record Surroundings(Room room, Pose pose, boolean lifted) {
    /** A contact within this angle of the bumper's middle presses both of its sides. */
    private static final double BUMPER_MIDDLE_RAD = Math.toRadians(20);

    private static final double BUMPER_END_RAD = Math.toRadians(80);
    private static final double TOUCH_MM = 1;

    /** The tolerance of the robot's pose on the dock for the contacts to touch: along, across, and in direction. */
    private static final double DOCKED_MM = 15;

    private static final double DOCKED_ASIDE_MM = 35;
    private static final double DOCKED_RAD = Math.toRadians(12);

    /** The sides of the bumper that are pressed. */
    public Set<Side> bumps() {
        Set<Side> pressed = EnumSet.noneOf(Side.class);
        if (!lifted) {
            for (Point wall : room.touched(pose, TOUCH_MM)) {
                double bearingRad = pose.bearingRadTo(wall.xMm(), wall.yMm());
                if (bearingRad > -BUMPER_MIDDLE_RAD && bearingRad < BUMPER_END_RAD) {
                    pressed.add(Side.LEFT);
                }
                if (bearingRad < BUMPER_MIDDLE_RAD && bearingRad > -BUMPER_END_RAD) {
                    pressed.add(Side.RIGHT);
                }
            }
        }
        return pressed;
    }

    /** The wheels that hang in the air. */
    public Set<Side> wheelDrops() {
        Set<Side> dropped = EnumSet.noneOf(Side.class);
        for (Side side : Side.values()) {
            double leftMm = (side == Side.LEFT ? 1 : -1) * Pose.WHEEL_BASE_MM / 2;
            if (lifted || room.isCliff(pose.ahead(0, leftMm))) {
                dropped.add(side);
            }
        }
        return dropped;
    }

    /** The sensors that miss the floor. */
    public Set<CliffSensor> cliffs() {
        Set<CliffSensor> missing = EnumSet.noneOf(CliffSensor.class);
        for (CliffSensor sensor : CliffSensor.values()) {
            if (lifted || room.isCliff(pose.ahead(sensor.forwardMm(), sensor.leftMm()))) {
                missing.add(sensor);
            }
        }
        return missing;
    }

    /** The signal of a light sensor, 0 to 4095. */
    public int lightSignal(LightSensor sensor) {
        return lifted ? 0 : LightSensor.signal(room.freeMm(pose, sensor.bearingRad()) - Room.ROBOT_RADIUS_MM);
    }

    /** Whether the robot is on the dock's contacts. */
    public boolean docked() {
        return !lifted && room.dock().filter(this::isOn).isPresent();
    }

    private boolean isOn(Pose dock) {
        Point inDockFrame = dock.seen(pose.center());
        double turnedRad = Math.IEEEremainder(pose.headingRad() - dock.headingRad(), 2 * Math.PI);
        return Math.abs(inDockFrame.xMm()) < DOCKED_MM
                && Math.abs(inDockFrame.yMm()) < DOCKED_ASIDE_MM
                && Math.abs(turnedRad) < DOCKED_RAD;
    }

    /** Whether the dock's beams reach the robot. */
    public boolean seesDock() {
        return !lifted && room.seesDock(pose);
    }
}
