package org.evoloop.roomba.simulator.body;

/**
 * The six that see what comes near the bumper, in the order of their packets.
 *
 * @since 0.1
 */
public enum LightSensor {
    /** 65 degrees to the left. */
    LEFT(0, 65),
    /** 38 degrees to the left. */
    FRONT_LEFT(1, 38),
    /** 12 degrees to the left. */
    CENTER_LEFT(2, 12),
    /** 12 degrees to the right. */
    CENTER_RIGHT(3, -12),
    /** 38 degrees to the right. */
    FRONT_RIGHT(4, -38),
    /** 65 degrees to the right. */
    RIGHT(5, -65);

    /** The threshold of packet 45. */
    private static final int NEAR_SIGNAL = 100;

    /** With these two a wall is near from about 220 mm on; the robot's own figures are not public. */
    private static final double STRONGEST_SIGNAL = 4_095;

    private static final double FADING_MM = 60;

    private final int bit;
    private final double bearingRad;

    LightSensor(int bit, double bearingDeg) {
        this.bit = bit;
        this.bearingRad = Math.toRadians(bearingDeg);
    }

    /** The number of this sensor's bit in packet 45. */
    public int bit() {
        return bit;
    }

    double bearingRad() {
        return bearingRad;
    }

    /** The sensor's signal for an obstacle at this distance from the bumper. */
    static int signal(double distanceMm) {
        return (int) (STRONGEST_SIGNAL * Math.exp(-Math.max(0, distanceMm) / FADING_MM));
    }

    /** Whether a signal means that something is near. */
    public static boolean isNear(int signal) {
        return signal > NEAR_SIGNAL;
    }
}
