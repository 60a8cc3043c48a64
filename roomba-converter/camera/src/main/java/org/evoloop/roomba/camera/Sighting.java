package org.evoloop.roomba.camera;

/**
 * The marker's position relative to the camera, on the plane of the floor.
 *
 * @param distanceMm from the camera to the marker's middle, in mm, not negative
 * @param bearingRad counterclockwise from straight ahead, -pi to pi
 * @since 0.1
 */
public record Sighting(double distanceMm, double bearingRad) {}
