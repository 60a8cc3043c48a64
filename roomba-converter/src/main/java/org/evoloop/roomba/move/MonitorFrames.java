package org.evoloop.roomba.move;

import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import org.evoloop.loop.MapeLoop;
import org.evoloop.loop.Monitor;
import org.evoloop.roomba.session.SessionListener;
import org.evoloop.roomba.session.Telemetry;
import org.jspecify.annotations.Nullable;

/** Monitors the robot's stream: it tells the newest frame, and one that nobody has looked at in time is gone. */
final class MonitorFrames extends Monitor<Telemetry> implements SessionListener {
    private final BlockingQueue<Telemetry> newest = new LinkedBlockingQueue<>(1);
    private final MapeLoop<Telemetry, ?, ?> loop;
    private final boolean threads;

    /** @param threads false if each frame itself must take the loop's step */
    MonitorFrames(MapeLoop<Telemetry, ?, ?> loop, boolean threads) {
        this.loop = loop;
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
    protected @Nullable Telemetry getEvent() throws InterruptedException {
        return threads ? newest.take() : newest.poll();
    }
}
