package org.evoloop.roomba.simulator.body;

/**
 * The four that look at the floor just behind the bumper, in the order of their packets.
 *
 * @since 0.1
 */
public enum CliffSensor {
    /** 60 degrees to the left. */
    LEFT(60),
    /** 15 degrees to the left. */
    FRONT_LEFT(15),
    /** 15 degrees to the right. */
    FRONT_RIGHT(-15),
    /** 60 degrees to the right. */
    RIGHT(-60);

    static final double RADIUS_MM = 150;

    private final double bearingRad;

    CliffSensor(double bearingDeg) {
        this.bearingRad = Math.toRadians(bearingDeg);
    }

    double forwardMm() {
        return RADIUS_MM * Math.cos(bearingRad);
    }

    double leftMm() {
        return RADIUS_MM * Math.sin(bearingRad);
    }
}
