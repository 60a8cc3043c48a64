package org.evoloop.roomba.simulator.body;

/** The four that look at the floor just behind the bumper, in the order of their packets. */
public enum CliffSensor {
    LEFT(60),
    FRONT_LEFT(15),
    FRONT_RIGHT(-15),
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
