package org.evoloop.study;

import java.util.Set;
import org.evoloop.converter.EventExecute;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Step;

/** Sends events to the simulated device, when it is ready, or seems so, or at once; none after a crash. */
final class RandomExecute extends EventExecute {
    /** As many as in holdoff.sm. */
    private static final int HOLDOFF_PHASES = 10;

    private final Surroundings surroundings;
    private final SimulatedTime time;
    private final RandomTimes times;
    private final Point point;
    private final SimulatedDevice device;
    private final Agreement agreement;
    private final Runnable handedOver;
    private long seemsReadyNanos;
    private boolean started;

    RandomExecute(
            Surroundings surroundings,
            SimulatedTime time,
            RandomTimes times,
            Point point,
            SimulatedDevice device,
            Agreement agreement,
            Runnable handedOver) {
        this.surroundings = surroundings;
        this.time = time;
        this.times = times;
        this.point = point;
        this.device = device;
        this.agreement = agreement;
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
            case SERIAL, PIPELINED -> surroundings.awaitDevice();
            case HOLDOFF -> surroundings.passUntil(seemsReadyNanos);
        }
    }

    @Override
    protected void send(Step step) {
        if (surroundings.crashed()) {
            return;
        }
        device.take();
        if (point.mechanism() == Point.Mechanism.HOLDOFF) {
            seemsReadyNanos = time.nanos()
                    + times.holdOff(point.holdOffSeconds(), HOLDOFF_PHASES).toNanos();
        }
        agreement.note(device.state().equals(step.target().name()), time.nanos());
    }

    /** Called once before the loop opens, and then whenever an event has been dealt with. */
    @Override
    protected void settled(Configuration now) {
        if (started && !surroundings.crashed()) {
            handedOver.run();
        }
        started = true;
    }
}
