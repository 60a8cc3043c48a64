package org.evoloop.roomba.move;

import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.function.BooleanSupplier;
import org.evoloop.function.Visit;
import org.evoloop.loop.MapeLoop;
import org.evoloop.loop.Monitor;
import org.evoloop.roomba.move.phase.Ending;
import org.evoloop.roomba.oi.Button;
import org.evoloop.roomba.session.SessionListener;
import org.evoloop.roomba.session.Telemetry;
import org.evoloop.roomba.session.inference.ActivityEstimate.EstimatedActivity;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;

/**
 * Monitors the robot's stream, whose newest frame is told, and with each frame what the sensor has seen last. The
 * frames set the pace, 15 ms each: a look is no older than that when it is told, and one that nobody needed costs
 * nothing.
 */
final class MonitorSenses extends Monitor<Percept> implements SessionListener {
    /** A frame, and what was done to the robot until then. */
    private record Heard(Telemetry telemetry, Ending person) {}

    private final BlockingQueue<Heard> newest = new LinkedBlockingQueue<>(1);
    private final MapeLoop<Percept, ?, ?> loop;
    private final StartPointSensor sensor;
    private final BooleanSupplier busy;
    private final Clock clock;
    private final boolean threads;
    private String reason = "";
    private Optional<EstimatedActivity> work = Optional.empty();

    /**
     * Without threads each frame itself takes the loop's step.
     *
     * @param busy whether the robot is being driven by somebody else, so that its frames say nothing to Move
     */
    MonitorSenses(MapeLoop<Percept, ?, ?> loop, StartPointSensor sensor, BooleanSupplier busy, Visit visit) {
        this.loop = loop;
        this.sensor = sensor;
        this.busy = busy;
        this.clock = visit.clock();
        this.threads = visit.threads();
    }

    @Override
    public void received(Telemetry telemetry) {
        if (busy.getAsBoolean()) {
            return;
        }
        Heard heard = new Heard(telemetry, reason.isEmpty() ? Ending.NONE : Ending.byPerson(reason, work));
        while (!newest.offer(heard)) {
            newest.poll();
        }
        if (!threads) {
            takeStep();
        }
    }

    /** Whoever presses a button of a robot that drives wants it to stop, whatever the button. */
    @Override
    public void pressed(Button button, boolean robotActs) {
        reason = button + " was pressed on the robot";
    }

    @Override
    public void stopped(String why) {
        reason = why;
    }

    @Override
    public void seen(EstimatedActivity activity) {
        work = activity == EstimatedActivity.ON ? Optional.empty() : Optional.of(activity);
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
        Heard heard = threads ? newest.take() : newest.poll();
        if (heard == null) {
            return null;
        }
        long nowNanos = clock.nanoTime();
        return new Percept(nowNanos, heard.telemetry(), sensor.look(heard.telemetry(), nowNanos), heard.person());
    }
}
