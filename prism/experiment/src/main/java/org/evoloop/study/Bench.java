package org.evoloop.study;

import java.time.Duration;
import org.evoloop.converter.PushMonitor;
import org.evoloop.converter.StateKnowledge;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.loop.LoopConfig;
import org.evoloop.time.ManualClock;

/**
 * A converter of the framework, a simulated device and a controller whose events arrive at random, all in the time of one
 * manual clock: whatever takes time in the loop advances the clock, and what falls due meanwhile (arrivals) happens then.
 *
 * <p>Threading: for one thread.
 */
final class Bench implements AutoCloseable {
    final ManualClock clock = new ManualClock();
    final SimulatedDevice device;
    private final Point point;
    private final RandomTimes times;
    private final PushMonitor controller = new PushMonitor("Controller");
    private final RandomExecute execute;
    private final SystemEventConverter converter;
    private long nextArrivalNanos;

    /** @param waits hears for how long each event that was taken has waited until it was handed over */
    Bench(Point point, long seed, WaitListener waits) {
        this.point = point;
        times = new RandomTimes(seed);
        device = new SimulatedDevice(clock, times, point.actionSeconds());
        RandomAnalyze analyze = new RandomAnalyze(clock, times, point, device);
        execute = new RandomExecute(
                clock,
                times,
                point,
                device,
                () -> waits.waited(Duration.ofNanos(clock.nanoTime() - analyze.observedNanos())));
        // The event that is in the loop has left the queue.
        converter = new SystemEventConverter(
                LoopConfig.defaults("study", clock).withoutThreads().withQueueCapacity(point.capacity() - 1));
        converter.addMonitor(controller);
        converter.addAnalyze(analyze);
        converter.addExecute(execute);
        converter.addKnowledge(new StateKnowledge(RingModels.pair()));
        converter.build();
        converter.start();
        scheduleArrival();
    }

    /** Hears of waiting times. */
    interface WaitListener {
        void waited(Duration wait);
    }

    private void scheduleArrival() {
        Duration delay = times.untilArrival(point.arrivalsPerSecond());
        nextArrivalNanos = clock.nanoTime() + delay.toNanos();
        clock.schedule(delay, this::arrive);
    }

    private void arrive() {
        scheduleArrival();
        controller.press(RingModels.event(point.steps()));
        try {
            converter.observe(controller);
        } catch (InterruptedException stop) {
            Thread.currentThread().interrupt();
        }
    }

    /** Converts the next event, or lets time pass until one arrives. */
    void go() {
        if (!converter.step()) {
            clock.advance(Duration.ofNanos(Math.max(0, nextArrivalNanos - clock.nanoTime())));
        }
    }

    /** Events lost so far, by the count of the converter's queue and of the device. */
    long lost() {
        return converter.status().queue().dropped() + device.lost();
    }

    /** Events that arrived so far. */
    long arrived() {
        return converter.status().queue().taken() + converter.status().queue().dropped();
    }

    /** When the converter's belief and the device differed first, in nanoseconds of the clock; negative while never. */
    long divergedNanos() {
        return execute.divergedNanos();
    }

    @Override
    public void close() {
        converter.close();
    }
}
