package org.evoloop.study;

import java.time.Duration;
import org.evoloop.time.Clock;

/**
 * A device with a ring of three states that an event moves on by one, which takes an action of random length. An event
 * that comes while it acts is lost.
 *
 * <p>Threading: for one thread at a time.
 */
final class SimulatedDevice {
    private final Clock clock;
    private final RandomTimes times;
    private final double actionSeconds;
    private final TimeLog ready = new TimeLog();
    private final TimeLog lost = new TimeLog();
    private int position;

    SimulatedDevice(Clock clock, RandomTimes times, double actionSeconds) {
        this.clock = clock;
        this.times = times;
        this.actionSeconds = actionSeconds;
    }

    /** An event arrives at the device. */
    void take() {
        if (untilReady().isZero()) {
            position = (position + 1) % RingModels.STATES.size();
            ready.add(clock.nanoTime() + times.action(actionSeconds).toNanos());
        } else {
            lost.add(clock.nanoTime());
        }
    }

    /** Somebody moves it on by hand, in no time. */
    void operate() {
        position = (position + 1) % RingModels.STATES.size();
    }

    /** How long it still acts. */
    Duration untilReady() {
        long readyNanos = ready.size() == 0 ? 0 : ready.at(ready.size());
        return Duration.ofNanos(Math.max(0, readyNanos - clock.nanoTime()));
    }

    /** Where it is. */
    String state() {
        return RingModels.STATES.get(position);
    }

    /** When each action ended, or will. */
    TimeLog ready() {
        return ready;
    }

    /** When events came while it acted. */
    TimeLog lost() {
        return lost;
    }
}
