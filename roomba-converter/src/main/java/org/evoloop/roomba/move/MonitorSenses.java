package org.evoloop.roomba.move;

import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import org.evoloop.loop.MapeLoop;
import org.evoloop.loop.Monitor;
import org.evoloop.roomba.session.SessionListener;
import org.evoloop.roomba.session.Telemetry;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;

/**
 * Monitors the robot's stream, whose newest frame is told, and with each frame what the sensor has seen last. The frames
 * set the pace, 15 ms each: a look is no older than that when it is told, and one that nobody needed costs nothing.
 */
final class MonitorSenses extends Monitor<Percept> implements SessionListener {
    private final BlockingQueue<Telemetry> newest = new LinkedBlockingQueue<>(1);
    private final MapeLoop<Percept, ?, ?> loop;
    private final StartPointSensor sensor;
    private final Clock clock;
    private final boolean threads;

    /** @param threads false if each frame itself must take the loop's step */
    MonitorSenses(MapeLoop<Percept, ?, ?> loop, StartPointSensor sensor, Clock clock, boolean threads) {
        this.loop = loop;
        this.sensor = sensor;
        this.clock = clock;
        this.threads = threads;
    }

    @Override
    public void received(Telemetry telemetry) {
        while (!newest.offer(telemetry)) {
            newest.poll();
        }
        if (!threads) {
            takeStep();
        }
    }

    private void takeStep() {
        try {
            loop.observe(this);
            loop.step();
        } catch (InterruptedException stop) {
            Thread.currentThread().interrupt();
        }
    }

    @Override
    protected @Nullable Percept getEvent() throws InterruptedException {
        Telemetry telemetry = threads ? newest.take() : newest.poll();
        if (telemetry == null) {
            return null;
        }
        long nowNanos = clock.nanoTime();
        return new Percept(nowNanos, telemetry, sensor.look(telemetry, nowNanos));
    }
}
