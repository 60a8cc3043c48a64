package org.evoloop.benchmarks.device;

/**
 * Answers presses of the simulated robot's CLEAN button: one of a robot that is idle and under control with the command
 * Clean, one of a cleaning robot, which pauses by itself, with Safe.
 */
interface Answerer extends AutoCloseable {
    /** How many presses have been answered. May be called from any thread. */
    long answered();

    @Override
    void close();
}
