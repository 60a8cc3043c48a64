package org.evoloop.study;

import java.time.Duration;
import org.evoloop.time.Clock;

/**
 * A device with a ring of three states that an event moves on by one, which takes an action of random length. An event
 * that comes while it acts is lost.
 *
 * <p>Threading: for one thread.
 */
final class SimulatedDevice {
    private final Clock clock;
    private final RandomTimes times;
    private final double actionSeconds;
    private int position;
    private long readyNanos;
    private long actions;
    private long lost;

    SimulatedDevice(Clock clock, RandomTimes times, double actionSeconds) {
        this.clock = clock;
        this.times = times;
        this.actionSeconds = actionSeconds;
    }

    /** An event arrives at the device. */
    void take() {
        if (untilReady().isZero()) {
            position = (position + 1) % RingModels.STATES.size();
            actions++;
            readyNanos = clock.nanoTime() + times.action(actionSeconds).toNanos();
        } else {
            lost++;
        }
    }

    /** How long it still acts. */
    Duration untilReady() {
        return Duration.ofNanos(Math.max(0, readyNanos - clock.nanoTime()));
    }

    /** Where it is. */
    String state() {
        return RingModels.STATES.get(position);
    }

    /** How many actions have begun. */
    long actions() {
        return actions;
    }

    /** When the last action ends, in nanoseconds of the clock. */
    long readyNanos() {
        return readyNanos;
    }

    /** How many events came while it acted. */
    long lost() {
        return lost;
    }
}
