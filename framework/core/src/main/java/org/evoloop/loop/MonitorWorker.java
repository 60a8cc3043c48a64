package org.evoloop.loop;

import java.time.Duration;
import java.util.concurrent.locks.LockSupport;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;

/**
 * The thread of a monitor.
 *
 * @param <O> an occurrence
 */
final class MonitorWorker<O> extends Worker {
    private static final long FIRST_PAUSE_MILLIS = 100;
    private static final long LONGEST_PAUSE_MILLIS = 5000;

    /** A monitor that takes at least this long has waited for something. */
    private static final long WAITS_NANOS = 100_000;

    private static final int PATIENCE = 1000;
    private static final long REST_NANOS = 10_000_000;

    private final Monitor<O> monitor;
    private final Sequencer<O> sequencer;
    private final Clock clock;
    private final @Nullable LoopThread thread;
    private long pauseMillis = FIRST_PAUSE_MILLIS;

    /** How many times in a row it has returned null at once. */
    private long idle;

    MonitorWorker(Monitor<O> monitor, LoopConfig config, Sequencer<O> sequencer, Crew crew) {
        super(monitor);
        this.monitor = monitor;
        this.sequencer = sequencer;
        this.clock = config.clock();
        this.thread = config.threads() ? new MonitorThread(crew, Crew.threadName(config, monitor)) : null;
    }

    private final class MonitorThread extends LoopThread {
        MonitorThread(Crew crew, String name) {
            super(crew, name);
        }

        @Override
        void round() throws InterruptedException {
            work();
        }
    }

    private void work() throws InterruptedException {
        if (!observe()) {
            clock.sleep(Duration.ofMillis(pauseMillis));
            pauseMillis = Math.min(2 * pauseMillis, LONGEST_PAUSE_MILLIS);
        }
    }

    /** Calls the monitor once, on the caller's thread; false if it failed. */
    boolean observe() throws InterruptedException {
        try {
            long asked = thread == null ? 0 : System.nanoTime();
            O occurrence = monitor.getEvent();
            if (occurrence == null) {
                rest(asked);
            } else {
                idle = 0;
                if (sequencer.offer(occurrence) != Intake.Admission.TAKEN) {
                    // It reports more than there is room for; at least it must not starve the others.
                    LoopThread.giveWay();
                }
            }
            pauseMillis = FIRST_PAUSE_MILLIS;
            return true;
        } catch (InterruptedException stop) {
            throw stop;
        } catch (Throwable cause) {
            sequencer.report(this, "getEvent", 0, null, cause);
            return false;
        }
    }

    /**
     * Pauses before a monitor that reported nothing is called again: one that waits by itself needs no pause, and any
     * other must not keep a processor busy.
     */
    private void rest(long askedNanos) {
        if (thread == null) {
            // Who takes the steps decides when the next one is.
            return;
        }
        idle = System.nanoTime() - askedNanos < WAITS_NANOS ? idle + 1 : 0;
        if (idle <= PATIENCE) {
            LoopThread.giveWay();
            return;
        }
        if (idle == PATIENCE + 1) {
            sequencer.report(
                    this,
                    "getEvent",
                    0,
                    null,
                    new Exception("keeps returning null without waiting; from now on it is called only every 10 ms"));
        }
        LockSupport.parkNanos(this, REST_NANOS);
    }

    @Override
    @Nullable
    LoopThread thread() {
        return thread;
    }

    @Override
    @Nullable
    LoopThread ownThread() {
        return thread;
    }

    @Override
    boolean isWorking() {
        return false;
    }

    @Override
    boolean isStuck() {
        return false;
    }
}
