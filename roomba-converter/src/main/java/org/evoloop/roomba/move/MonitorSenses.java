package org.evoloop.roomba.move;

import java.time.Duration;
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
 * Monitors the robot's stream and reports its newest frame together with the sensor's last look. The frames set the
 * pace, one every 15 ms, so a look is reported at most 15 ms late, and unneeded looks cost nothing. When none comes for
 * the frame limit, the last one is reported once more as not heard, again and again until the next.
 */
final class MonitorSenses extends Monitor<Percept> implements SessionListener {
    /** A frame, what a person has done to the robot by then, and whether it was just heard. */
    private record Frame(Telemetry telemetry, Ending person, boolean heard) {}

    private final BlockingQueue<Frame> newest = new LinkedBlockingQueue<>(1);
    private final MapeLoop<Percept, ?, ?> loop;
    private final StartPointSensor sensor;
    private final BooleanSupplier busy;
    private final Clock clock;
    private final boolean threads;
    private final Duration frameLimit;
    /** The last frame; null before the first, and while something else drives the robot. */
    private @Nullable Telemetry last;

    private long heardNanos;
    private Clock.@Nullable Timer silenceCheck;
    private boolean closed;
    private volatile String reason = "";
    private Optional<EstimatedActivity> work = Optional.empty();

    /**
     * Without threads, each frame triggers a step of the loop.
     *
     * @param busy whether something else is driving the robot, so that Move must ignore its frames
     * @param frameLimit how long no frame may come
     */
    MonitorSenses(
            MapeLoop<Percept, ?, ?> loop,
            StartPointSensor sensor,
            BooleanSupplier busy,
            Duration frameLimit,
            Visit visit) {
        this.frameLimit = frameLimit;
        this.loop = loop;
        this.sensor = sensor;
        this.busy = busy;
        this.clock = visit.clock();
        this.threads = visit.threads();
    }

    @Override
    public void received(Telemetry telemetry) {
        boolean heard = !busy.getAsBoolean();
        hear(heard ? telemetry : null);
        if (!heard) {
            return;
        }
        Frame frame = new Frame(telemetry, reason.isEmpty() ? Ending.NONE : Ending.byPerson(reason, work), true);
        while (!newest.offer(frame)) {
            newest.poll();
        }
        if (!threads) {
            takeStep();
        }
    }

    private synchronized void hear(@Nullable Telemetry telemetry) {
        last = telemetry;
        heardNanos = clock.nanoTime();
        if (silenceCheck == null) {
            checkAfter(frameLimit);
        }
    }

    private synchronized void checkAfter(Duration delay) {
        if (!closed) {
            silenceCheck = clock.schedule(delay, this::checkSilence);
        }
    }

    private void checkSilence() {
        Telemetry frame;
        Duration left;
        synchronized (this) {
            frame = last;
            left = frameLimit.minusNanos(clock.nanoTime() - heardNanos);
        }
        boolean silent = left.isNegative() || left.isZero();
        if (silent && frame != null && newest.offer(new Frame(frame, Ending.NONE, false)) && !threads) {
            takeStep();
        }
        checkAfter(silent ? frameLimit : left);
    }

    /** Ends the check for silence. */
    synchronized void close() {
        closed = true;
        if (silenceCheck != null) {
            silenceCheck.cancel();
        }
    }

    /** Any button pressed while the robot drives means "stop". */
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
        Frame frame = threads ? newest.take() : newest.poll();
        if (frame == null) {
            return null;
        }
        long nowNanos = clock.nanoTime();
        return new Percept(
                nowNanos, frame.telemetry(), sensor.look(frame.telemetry(), nowNanos), frame.person(), frame.heard());
    }
}
