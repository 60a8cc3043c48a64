package org.evoloop.loop;

import java.time.Duration;
import org.evoloop.time.Clock;

/**
 * The thread of a monitor.
 *
 * @param <O> an occurrence
 */
final class MonitorWorker<O> extends Worker {
    private static final long FIRST_PAUSE_MILLIS = 100;
    private static final long LONGEST_PAUSE_MILLIS = 5000;

    private final Monitor<O> monitor;
    private final Sequencer<O> sequencer;
    private final Clock clock;
    private long pauseMillis = FIRST_PAUSE_MILLIS;

    MonitorWorker(Monitor<O> monitor, LoopConfig config, Sequencer<O> sequencer) {
        super(monitor, config);
        this.monitor = monitor;
        this.sequencer = sequencer;
        this.clock = config.clock();
    }

    @Override
    void work() throws InterruptedException {
        if (!observe()) {
            clock.sleep(Duration.ofMillis(pauseMillis));
            pauseMillis = Math.min(2 * pauseMillis, LONGEST_PAUSE_MILLIS);
        }
    }

    /** Asks the monitor once, on the caller's thread; false if it failed. */
    boolean observe() throws InterruptedException {
        try {
            O occurrence = monitor.getEvent();
            if (occurrence == null || !sequencer.offer(occurrence)) {
                // It polls, or tells more than there is room for; at least it shall not starve the others.
                giveWay();
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

    @Override
    boolean isWorking() {
        return false;
    }
}
