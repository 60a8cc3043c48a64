package org.evoloop.roomba.move.phase;

/**
 * When the robot has arrived.
 *
 * @param distanceMm the distance from the sensed place
 * @param toleranceMm how far the distance may be off
 * @param facing whether the robot must also face the place
 */
public record Target(double distanceMm, double toleranceMm, boolean facing) {}
