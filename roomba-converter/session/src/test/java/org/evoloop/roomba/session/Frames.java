package org.evoloop.roomba.session;

import org.evoloop.roomba.oi.OiMode;
import org.evoloop.roomba.oi.Packet;
import org.evoloop.roomba.oi.SensorValues;

/** Stream frames as a robot might send them. */
public final class Frames {
    /** The time between two frames. */
    public static final long APART_NANOS = 15_000_000;

    private Frames() {}

    /** A robot at rest in this mode. */
    public static SensorValues resting(OiMode mode) {
        return SensorValues.of(RoombaSession.STREAM, packet -> switch (packet) {
            case OI_MODE -> mode.code();
            case CURRENT -> -200;
            default -> 0;
        });
    }

    /** A robot cleaning by itself. */
    public static SensorValues cleaning() {
        return resting(OiMode.PASSIVE).with(Packet.CURRENT, -1_100).with(Packet.MAIN_BRUSH_CURRENT, 400);
    }

    public static SensorValues encoders(int left, int right) {
        return resting(OiMode.PASSIVE).with(Packet.LEFT_ENCODER, (short) left).with(Packet.RIGHT_ENCODER, (short)
                right);
    }
}
