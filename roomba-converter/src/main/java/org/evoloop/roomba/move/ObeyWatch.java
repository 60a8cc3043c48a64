package org.evoloop.roomba.move;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.function.ToIntFunction;
import org.evoloop.roomba.move.phase.Maneuver;
import org.evoloop.roomba.oi.ActuatorCommand.DriveDirect;
import org.evoloop.roomba.oi.SensorValues;
import org.jspecify.annotations.Nullable;

/**
 * Checks by the encoders that the wheels turn as commanded: forward, backward or not at all. A robot that commands no
 * longer reach keeps executing the last one, and the serial port reports no error: it accepts bytes that nobody reads.
 *
 * <p>Threading: thread-safe.
 */
final class ObeyWatch {
    private record Command(long nanos, DriveDirect wheels) {}

    private final long reactionNanos;
    private final long patienceNanos;
    private final long sampleNanos;
    private final Deque<Command> commands = new ArrayDeque<>();
    private @Nullable SensorValues sample;
    private long sampledNanos;
    private boolean wrong;
    private long wrongNanos;
    private boolean reported;

    /** @param frameLimitNanos how late the robot's reaction may show on a busy computer, 300 ms for a real robot */
    ObeyWatch(long frameLimitNanos) {
        this.reactionNanos = 2 * frameLimitNanos;
        this.patienceNanos = 3 * frameLimitNanos;
        this.sampleNanos = frameLimitNanos / 3;
    }

    /** Records a wheel command. */
    synchronized void commanded(DriveDirect wheels, long nanos) {
        commands.addLast(new Command(nanos, wheels));
    }

    /** Processes the next frame. Returns true once, when it is certain that the wheels do not turn as commanded. */
    synchronized boolean update(SensorValues values, boolean underControl, long nanos) {
        SensorValues earlier = sample;
        if (!underControl || earlier == null) {
            wrong = false;
            keep(values, nanos);
            return false;
        }
        if (nanos - sampledNanos < sampleNanos) {
            return false;
        }
        dropSuperseded(nanos);
        boolean now = differs(
                        DriveDirect::leftMmPerS,
                        SensorValues.encoderDelta(earlier.leftEncoderCounts(), values.leftEncoderCounts()))
                || differs(
                        DriveDirect::rightMmPerS,
                        SensorValues.encoderDelta(earlier.rightEncoderCounts(), values.rightEncoderCounts()));
        if (now && !wrong) {
            wrongNanos = nanos;
        }
        wrong = now;
        keep(values, nanos);
        boolean clear = wrong && !reported && nanos - wrongNanos >= patienceNanos;
        reported |= clear;
        return clear;
    }

    private void keep(SensorValues values, long nanos) {
        sample = values;
        sampledNanos = nanos;
    }

    /** Removes superseded commands. A command counts until {@code reactionNanos} after the next one. */
    private void dropSuperseded(long nanos) {
        while (commands.size() > 1) {
            Command first = commands.removeFirst();
            if (nanos - commands.getFirst().nanos() < reactionNanos) {
                commands.addFirst(first);
                return;
            }
        }
    }

    /** Whether a wheel's direction matches none of the recent commands. */
    private boolean differs(ToIntFunction<DriveDirect> wheel, int counts) {
        // A wheel at rest may flip between two adjacent encoder counts.
        int direction = Math.abs(counts) <= 1 ? 0 : Integer.signum(counts);
        for (Command each : commands) {
            int speed = wheel.applyAsInt(each.wheels());
            boolean tooSlowToMeasure = speed != 0 && Math.abs(speed) < Maneuver.SLOWEST_MM_PER_S;
            if (tooSlowToMeasure || Integer.signum(speed) == direction) {
                return false;
            }
        }
        return !commands.isEmpty();
    }
}
