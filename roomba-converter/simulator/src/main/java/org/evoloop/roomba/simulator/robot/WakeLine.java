package org.evoloop.roomba.simulator.robot;

import org.evoloop.roomba.simulator.body.Body;

/**
 * The line that wakes the robot when it goes low, and that switches it to 19200 baud by three short pulses in the time
 * after power-on (specification, "Serial Port Settings"). Time is counted in ticks.
 */
final class WakeLine {
    /** A pulse of 50 ms spans three full ticks or more. */
    private static final int SHORTEST_PULSE_TICKS = 50 / Body.TICK_MILLIS;

    private static final int LONGEST_SHORT_PULSE_TICKS = 500 / Body.TICK_MILLIS + 1;
    private static final int PULSES = 3;

    /** The specification requires the client to wait for 2 s; it does not say when the window ends. */
    private static final int WINDOW_BEGIN_TICKS = 2_000 / Body.TICK_MILLIS;

    private static final int WINDOW_END_TICKS = 20_000 / Body.TICK_MILLIS;

    private boolean low;
    private int lowTicks;
    private int shortPulses;
    private int ticksOn;

    void powerOn() {
        ticksOn = 0;
        shortPulses = 0;
    }

    /**
     * Pulls the line low or releases it.
     *
     * @return whether this completes the pulses for 19200 baud
     */
    boolean set(boolean nowLow) {
        boolean released = low && !nowLow;
        boolean isShort = lowTicks >= SHORTEST_PULSE_TICKS && lowTicks <= LONGEST_SHORT_PULSE_TICKS;
        boolean inTime = ticksOn >= WINDOW_BEGIN_TICKS && ticksOn <= WINDOW_END_TICKS;
        low = nowLow;
        if (released) {
            lowTicks = 0;
            if (isShort && inTime) {
                shortPulses++;
                return shortPulses == PULSES;
            }
        }
        return false;
    }

    /** Simulates one tick; returns whether the robot now notices that the line is low. */
    boolean tick() {
        ticksOn++;
        if (low) {
            lowTicks++;
        }
        return low && lowTicks == SHORTEST_PULSE_TICKS;
    }
}
