package org.evoloop.roomba.camera;

/**
 * Where the marker is seen from the camera, on the floor's plane.
 *
 * @param distanceMm from the camera to the marker's middle, in mm, not negative
 * @param bearingRad counterclockwise from straight ahead, -pi to pi
 * @since 0.1
 */
public record Sighting(double distanceMm, double bearingRad) {}
