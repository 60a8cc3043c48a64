package org.evoloop.study;

import java.util.Set;
import org.evoloop.converter.EventExecute;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Step;

/** Sends events to the simulated device, when it is ready, or seems so, or at once. */
final class RandomExecute extends EventExecute {
    /** As many as in holdoff.sm. */
    private static final int HOLDOFF_PHASES = 10;

    private final SimulatedTime time;
    private final RandomTimes times;
    private final Point point;
    private final SimulatedDevice device;
    private final Runnable handedOver;
    private long seemsReadyNanos;
    private boolean started;
    private long divergedNanos = -1;

    RandomExecute(SimulatedTime time, RandomTimes times, Point point, SimulatedDevice device, Runnable handedOver) {
        this.time = time;
        this.times = times;
        this.point = point;
        this.device = device;
        this.handedOver = handedOver;
    }

    @Override
    protected Set<String> sendableEvents() {
        return Set.of(RingModels.NEXT);
    }

    @Override
    protected void awaitReady(Step step) {
        switch (point.mechanism()) {
            case UNBUFFERED -> {}
            case SERIAL, PIPELINED -> time.pass(device.untilReady());
            case HOLDOFF -> time.passUntil(seemsReadyNanos);
        }
    }

    @Override
    protected void send(Step step) {
        device.take();
        if (point.mechanism() == Point.Mechanism.HOLDOFF) {
            seemsReadyNanos = time.nanos()
                    + times.holdOff(point.holdOffSeconds(), HOLDOFF_PHASES).toNanos();
        }
        if (divergedNanos < 0 && !device.state().equals(step.target().name())) {
            divergedNanos = time.nanos();
        }
    }

    /** Called once before the loop opens, and then whenever an event has been dealt with. */
    @Override
    protected void settled(Configuration now) {
        if (started) {
            handedOver.run();
        }
        started = true;
    }

    /** When the device was first not where the converter took it to be; negative while never. */
    long divergedNanos() {
        return divergedNanos;
    }
}
