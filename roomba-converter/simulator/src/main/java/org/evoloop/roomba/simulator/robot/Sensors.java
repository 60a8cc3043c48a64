package org.evoloop.roomba.simulator.robot;

import java.util.Set;
import org.evoloop.roomba.oi.Button;
import org.evoloop.roomba.oi.ChargingState;
import org.evoloop.roomba.oi.FirmwareVersion;
import org.evoloop.roomba.oi.Packet;
import org.evoloop.roomba.simulator.body.Battery;
import org.evoloop.roomba.simulator.body.Body;
import org.evoloop.roomba.simulator.body.CliffSensor;
import org.evoloop.roomba.simulator.body.LightSensor;
import org.evoloop.roomba.simulator.body.Side;
import org.evoloop.roomba.simulator.room.Pose;

/** The values of the sensors. Reading distance or angle resets it, as on the robot. */
final class Sensors {
    static final int TEMPERATURE_CELSIUS = 25;

    /** The cliff sensors' signal over a floor of medium brightness. */
    private static final int FLOOR_SIGNAL = 2_700;

    private static final int CLIFF_SIGNAL = 30;

    /** The wall sensor has two bits less than the light sensors. */
    private static final int WALL_SIGNAL_SHIFT = 2;

    private static final int HOME_BASE = 2;

    /** Infrared characters of the dock: its red and green beams, and these with its force field. */
    private static final int DOCK_BEAMS = 172;

    private static final int DOCK_BEAMS_AND_FIELD = 173;
    private static final double DOCK_FIELD_MM = 600;

    private static final FirmwareVersion FIRST_RIGHT_DISTANCE = new FirmwareVersion(3, 3, 0);
    private static final FirmwareVersion LAST_WRONG_ANGLE = new FirmwareVersion(3, 4, 0);

    /** As measured on a robot: it reports less than it drove, with the opposite sign. */
    private static final double WRONG_DISTANCE = -1 / 8.0;

    /** From the specification's appendix on firmware versions. */
    private static final double WRONG_ANGLE = 0.324056;

    private final Body body;
    private final Firmware firmware;
    private final RobotOptions options;
    private final double distanceFactor;
    private final double angleFactor;
    private final long leftCountsAtBoot;
    private final long rightCountsAtBoot;
    private final Trip distance;
    private final Trip angle;

    Sensors(Body body, Firmware firmware, RobotOptions options) {
        this.body = body;
        this.firmware = firmware;
        this.options = options;
        this.distanceFactor = options.firmware().compareTo(FIRST_RIGHT_DISTANCE) < 0 ? WRONG_DISTANCE : 1;
        this.angleFactor = options.firmware().compareTo(LAST_WRONG_ANGLE) <= 0 ? WRONG_ANGLE : 1;
        this.leftCountsAtBoot = body.left().counts();
        this.rightCountsAtBoot = body.right().counts();
        this.distance = new Trip(distanceFactor * body.travelledMm());
        this.angle = new Trip(angleFactor * body.turnedDeg());
    }

    /** A counter that is reset by reading; the fraction is kept for the next reading. */
    private static final class Trip {
        private double seen;

        Trip(double total) {
            this.seen = total;
        }

        int take(double total) {
            int since = (int) (total - seen);
            int reported = Math.max(Short.MIN_VALUE, Math.min(Short.MAX_VALUE, since));
            seen += since;
            return reported;
        }
    }

    int value(Packet packet) {
        return switch (packet) {
            case VIRTUAL_WALL, OVERCURRENTS, DIRT_DETECT, UNUSED_16, UNUSED_32, UNUSED_33 -> 0;
            case BUMPS_AND_WHEEL_DROPS ->
                bits(body.surroundings().bumps()) | bits(body.surroundings().wheelDrops()) << 2;
            case WALL -> LightSensor.isNear(light(LightSensor.RIGHT)) ? 1 : 0;
            case WALL_SIGNAL -> light(LightSensor.RIGHT) >> WALL_SIGNAL_SHIFT;
            case CLIFF_LEFT -> cliff(CliffSensor.LEFT, 1, 0);
            case CLIFF_FRONT_LEFT -> cliff(CliffSensor.FRONT_LEFT, 1, 0);
            case CLIFF_FRONT_RIGHT -> cliff(CliffSensor.FRONT_RIGHT, 1, 0);
            case CLIFF_RIGHT -> cliff(CliffSensor.RIGHT, 1, 0);
            case CLIFF_LEFT_SIGNAL -> cliff(CliffSensor.LEFT, CLIFF_SIGNAL, FLOOR_SIGNAL);
            case CLIFF_FRONT_LEFT_SIGNAL -> cliff(CliffSensor.FRONT_LEFT, CLIFF_SIGNAL, FLOOR_SIGNAL);
            case CLIFF_FRONT_RIGHT_SIGNAL -> cliff(CliffSensor.FRONT_RIGHT, CLIFF_SIGNAL, FLOOR_SIGNAL);
            case CLIFF_RIGHT_SIGNAL -> cliff(CliffSensor.RIGHT, CLIFF_SIGNAL, FLOOR_SIGNAL);
            case LIGHT_BUMPER -> lightBumper();
            case LIGHT_BUMP_LEFT_SIGNAL -> light(LightSensor.LEFT);
            case LIGHT_BUMP_FRONT_LEFT_SIGNAL -> light(LightSensor.FRONT_LEFT);
            case LIGHT_BUMP_CENTER_LEFT_SIGNAL -> light(LightSensor.CENTER_LEFT);
            case LIGHT_BUMP_CENTER_RIGHT_SIGNAL -> light(LightSensor.CENTER_RIGHT);
            case LIGHT_BUMP_FRONT_RIGHT_SIGNAL -> light(LightSensor.FRONT_RIGHT);
            case LIGHT_BUMP_RIGHT_SIGNAL -> light(LightSensor.RIGHT);
            case INFRARED_OMNI, INFRARED_LEFT, INFRARED_RIGHT -> infrared();
            case BUTTONS -> Button.toBits(firmware.pressed());
            case DISTANCE -> distance.take(distanceFactor * body.travelledMm());
            case ANGLE -> angle.take(angleFactor * body.turnedDeg());
            case CHARGING_STATE -> chargingState().code();
            case VOLTAGE -> body.battery().milliVolts();
            case CURRENT -> body.batteryMilliAmps();
            case TEMPERATURE -> TEMPERATURE_CELSIUS;
            case BATTERY_CHARGE -> body.battery().chargeMilliAmpHours();
            case BATTERY_CAPACITY -> Battery.CAPACITY_MILLI_AMP_HOURS;
            case CHARGING_SOURCES -> body.surroundings().docked() ? HOME_BASE : 0;
            case OI_MODE -> firmware.mode().code() + options.modeOffset();
            case SONG_NUMBER -> firmware.speaker().number();
            case SONG_PLAYING -> firmware.speaker().isPlaying() ? 1 : 0;
            case NUMBER_OF_STREAM_PACKETS -> firmware.reporter().streamPackets();
            case REQUESTED_VELOCITY -> firmware.actuators().requestedDrive().velocityMmPerS();
            case REQUESTED_RADIUS -> firmware.actuators().requestedDrive().radiusMm();
            case REQUESTED_RIGHT_VELOCITY ->
                firmware.actuators().requestedDirect().rightMmPerS();
            case REQUESTED_LEFT_VELOCITY ->
                firmware.actuators().requestedDirect().leftMmPerS();
            case LEFT_ENCODER -> (short) (body.left().counts() - leftCountsAtBoot);
            case RIGHT_ENCODER -> (short) (body.right().counts() - rightCountsAtBoot);
            case LEFT_MOTOR_CURRENT -> body.left().motorMilliAmps();
            case RIGHT_MOTOR_CURRENT -> body.right().motorMilliAmps();
            case MAIN_BRUSH_CURRENT -> body.cleaningMotors().mainBrushMilliAmps();
            case SIDE_BRUSH_CURRENT -> body.cleaningMotors().sideBrushMilliAmps();
            case STASIS -> body.frontWheelLight() ? 1 : 0;
        };
    }

    /** Bit 0 is the right side, as in packet 7. */
    private static int bits(Set<Side> sides) {
        return (sides.contains(Side.RIGHT) ? 1 : 0) | (sides.contains(Side.LEFT) ? 2 : 0);
    }

    private int cliff(CliffSensor sensor, int withoutFloor, int withFloor) {
        return body.surroundings().cliffs().contains(sensor) ? withoutFloor : withFloor;
    }

    private int light(LightSensor sensor) {
        return body.surroundings().lightSignal(sensor);
    }

    private int lightBumper() {
        int bits = 0;
        for (LightSensor sensor : LightSensor.values()) {
            bits |= LightSensor.isNear(light(sensor)) ? 1 << sensor.bit() : 0;
        }
        return bits;
    }

    /** All three receivers report the same value: which beam goes to which side is not documented. */
    private int infrared() {
        Pose dock = body.room().dock().orElse(null);
        if (dock == null || !body.surroundings().seesDock()) {
            return 0;
        }
        return body.pose().distanceMmTo(dock.center()) < DOCK_FIELD_MM ? DOCK_BEAMS_AND_FIELD : DOCK_BEAMS;
    }

    private ChargingState chargingState() {
        if (!body.isCharging()) {
            return ChargingState.NOT_CHARGING;
        }
        return body.battery().isFull() ? ChargingState.TRICKLE_CHARGING : ChargingState.FULL_CHARGING;
    }
}
