package org.evoloop.roomba.simulator.robot;

import org.evoloop.roomba.oi.Button;
import org.evoloop.roomba.oi.ChargingState;
import org.evoloop.roomba.oi.Packet;
import org.evoloop.roomba.simulator.body.Battery;
import org.evoloop.roomba.simulator.body.Body;

/** What the sensors tell. Reading distance and angle starts their count anew, as on the robot. */
final class Sensors {
    private static final int TEMPERATURE_CELSIUS = 25;

    /** The cliff sensors' signal over a floor of middling brightness. */
    private static final int FLOOR_SIGNAL = 2_700;

    private final Body body;
    private final Firmware firmware;
    private final long leftCountsAtBoot;
    private final long rightCountsAtBoot;
    private final Trip distance;
    private final Trip angle;

    Sensors(Body body, Firmware firmware) {
        this.body = body;
        this.firmware = firmware;
        this.leftCountsAtBoot = body.left().counts();
        this.rightCountsAtBoot = body.right().counts();
        this.distance = new Trip(body.travelledMm());
        this.angle = new Trip(body.turnedDeg());
    }

    /** A count since the last look at it; the fraction that a look leaves over goes into the next. */
    private static final class Trip {
        private double seen;

        Trip(double total) {
            this.seen = total;
        }

        int take(double total) {
            int since = (int) (total - seen);
            int told = Math.max(Short.MIN_VALUE, Math.min(Short.MAX_VALUE, since));
            seen += since;
            return told;
        }
    }

    int value(Packet packet) {
        return switch (packet) {
            case BUMPS_AND_WHEEL_DROPS,
                    WALL,
                    CLIFF_LEFT,
                    CLIFF_FRONT_LEFT,
                    CLIFF_FRONT_RIGHT,
                    CLIFF_RIGHT,
                    VIRTUAL_WALL,
                    OVERCURRENTS,
                    DIRT_DETECT,
                    UNUSED_16,
                    INFRARED_OMNI,
                    WALL_SIGNAL,
                    UNUSED_32,
                    UNUSED_33,
                    CHARGING_SOURCES,
                    LIGHT_BUMPER,
                    LIGHT_BUMP_LEFT_SIGNAL,
                    LIGHT_BUMP_FRONT_LEFT_SIGNAL,
                    LIGHT_BUMP_CENTER_LEFT_SIGNAL,
                    LIGHT_BUMP_CENTER_RIGHT_SIGNAL,
                    LIGHT_BUMP_FRONT_RIGHT_SIGNAL,
                    LIGHT_BUMP_RIGHT_SIGNAL,
                    INFRARED_LEFT,
                    INFRARED_RIGHT -> 0;
            case CLIFF_LEFT_SIGNAL, CLIFF_FRONT_LEFT_SIGNAL, CLIFF_FRONT_RIGHT_SIGNAL, CLIFF_RIGHT_SIGNAL ->
                FLOOR_SIGNAL;
            case BUTTONS -> Button.toBits(firmware.pressed());
            case DISTANCE -> distance.take(body.travelledMm());
            case ANGLE -> angle.take(body.turnedDeg());
            case CHARGING_STATE -> ChargingState.NOT_CHARGING.code();
            case VOLTAGE -> body.battery().milliVolts();
            case CURRENT -> body.batteryMilliAmps();
            case TEMPERATURE -> TEMPERATURE_CELSIUS;
            case BATTERY_CHARGE -> body.battery().chargeMilliAmpHours();
            case BATTERY_CAPACITY -> Battery.CAPACITY_MILLI_AMP_HOURS;
            case OI_MODE -> firmware.mode().code();
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
}
