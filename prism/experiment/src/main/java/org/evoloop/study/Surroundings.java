package org.evoloop.study;

import java.time.Duration;

/**
 * What happens around a converter at random times, and the time that passes for it: none after its process has crashed.
 *
 * <p>Threading: for one thread at a time.
 */
final class Surroundings {
    /** Hears of what happens; called while time passes. */
    interface Listener {
        void crashed();

        void found();

        /** The device was operated while out of sight. */
        void operated();
    }

    private static final long NEVER = Long.MAX_VALUE;

    private final SimulatedTime time;
    private final RandomTimes times;
    private final Disturbances means;
    private final SimulatedDevice device;
    private final Listener listener;
    private long crashNanos = NEVER;
    private long swapNanos = NEVER;
    private long foundNanos;
    private boolean crashed;
    private boolean inSight = true;

    Surroundings(SimulatedTime time, RandomTimes times, Disturbances means, SimulatedDevice device, Listener listener) {
        this.time = time;
        this.times = times;
        this.means = means;
        this.device = device;
        this.listener = listener;
        started();
        swapped();
        if (means.sight() > 0) {
            after(means.sight(), this::lose);
        }
    }

    /** When {@code happening} will be. */
    private long after(double meanSeconds, Runnable happening) {
        Duration delay = times.untilDisturbance(meanSeconds);
        time.clock().schedule(delay, happening);
        return time.nanos() + delay.toNanos();
    }

    /** A process of the converter begins. */
    void started() {
        crashed = false;
        crashNanos = means.crash() > 0 ? after(means.crash(), this::crash) : NEVER;
    }

    private void crash() {
        crashed = true;
        crashNanos = NEVER;
        listener.crashed();
    }

    boolean crashed() {
        return crashed;
    }

    Duration untilRecovery() {
        return times.untilDisturbance(means.recovery());
    }

    /** Other models have taken over, or the first ones have begun. */
    void swapped() {
        swapNanos = means.swap() > 0
                ? time.nanos() + times.untilDisturbance(means.swap()).toNanos()
                : NEVER;
    }

    /** Whether other models are to take over. */
    boolean wantsSwap() {
        return swapNanos <= time.nanos();
    }

    /** No event can begin meanwhile. */
    void pause() {
        time.pass(times.untilDisturbance(means.pause()));
    }

    private void lose() {
        inSight = false;
        foundNanos = after(means.away(), this::find);
        operateLater();
    }

    private void operateLater() {
        if (means.operated() > 0) {
            long losing = foundNanos;
            after(1 / means.operated(), () -> {
                if (!inSight && losing == foundNanos) {
                    listener.operated();
                    operateLater();
                }
            });
        }
    }

    private void find() {
        inSight = true;
        after(means.sight(), this::lose);
        listener.found();
    }

    /** When something happens next that concerns a converter that has nothing to do. */
    long nextNanos() {
        return Math.min(crashNanos, swapNanos);
    }

    /** Lets time pass for the converter. */
    void pass(Duration duration) {
        passUntil(time.nanos() + duration.toNanos());
    }

    /** The same until then. */
    void passUntil(long nanos) {
        if (!crashed) {
            time.passUntil(Math.min(nanos, crashNanos));
        }
    }

    /** Lets time pass until the device is ready, and in sight. */
    void awaitDevice() {
        while (!crashed && !(inSight && device.untilReady().isZero())) {
            passUntil(inSight ? time.nanos() + device.untilReady().toNanos() : foundNanos);
        }
    }
}
