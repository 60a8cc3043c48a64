package org.evoloop.study;

import java.time.Duration;
import org.evoloop.converter.PushMonitor;
import org.evoloop.converter.StateKnowledge;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.loop.LoopConfig;

/**
 * A converter of the framework, a simulated device and a controller whose events arrive at random, all in one simulated
 * time: it passes while something in the loop takes time, and what falls due meanwhile (arrivals) happens then.
 *
 * <p>Threading: for one thread. If the loop has threads of its own they take turns with that one: time passes by their
 * doing while there is an event in the loop, by the bench's while there is none. So the same seed gives the same run.
 */
final class Bench implements AutoCloseable {
    /** In the clock's time: the device may take as long as it likes. */
    private static final Duration NO_LIMIT = Duration.ofDays(365);

    final SimulatedTime time = new SimulatedTime();
    final Arrivals arrivals = new Arrivals();
    final SimulatedDevice device;
    private final Point point;
    private final RandomTimes times;
    private final PushMonitor controller = new PushMonitor("Controller");
    private final RandomExecute execute;
    private final SystemEventConverter converter;
    private final LoopDriver driver;
    private long nextArrivalNanos;

    Bench(Point point, long seed, boolean threads) {
        this.point = point;
        times = new RandomTimes(seed);
        device = new SimulatedDevice(time.clock(), times, point.actionSeconds());
        RandomAnalyze analyze = new RandomAnalyze(time, times, point, device);
        execute = new RandomExecute(time, times, point, device, () -> handedOver(analyze.observedNanos()));
        // The event that is in the loop has left the queue.
        LoopConfig config = LoopConfig.defaults("study", time.clock())
                .withQueueCapacity(point.capacity() - 1)
                .withStepLimit(NO_LIMIT);
        converter = new SystemEventConverter(threads ? config : config.withoutThreads());
        driver = threads ? new ThreadsDriver(converter) : new StepsDriver(converter, controller);
        converter.addMonitor(controller);
        converter.addAnalyze(analyze);
        converter.addExecute(execute);
        converter.addKnowledge(new StateKnowledge(RingModels.pair()));
        converter.build();
        converter.start();
        scheduleArrival();
    }

    private void handedOver(long arrivedNanos) {
        arrivals.handOver(arrivedNanos, time.nanos());
        driver.dealtWith();
    }

    private void scheduleArrival() {
        // No two events arrive at the same time: it is what tells them apart.
        long delay = Math.max(1, times.untilArrival(point.arrivalsPerSecond()).toNanos());
        nextArrivalNanos = time.nanos() + delay;
        time.clock().schedule(Duration.ofNanos(delay), this::arrive);
    }

    private void arrive() {
        scheduleArrival();
        arrivals.arrive(time.nanos());
        controller.press(RingModels.event(point.steps()));
        driver.pressed();
    }

    /** Lets time pass until an event arrives, and until the converter has nothing left to do. */
    void go() {
        time.passUntil(nextArrivalNanos);
        driver.settle();
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
