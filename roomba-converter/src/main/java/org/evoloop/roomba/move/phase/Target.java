package org.evoloop.roomba.move.phase;

/**
 * Where the robot has arrived.
 *
 * @param distanceMm so far from what is sensed
 * @param toleranceMm give or take so much
 * @param facing whether it must also look at it
 */
public record Target(double distanceMm, double toleranceMm, boolean facing) {}
