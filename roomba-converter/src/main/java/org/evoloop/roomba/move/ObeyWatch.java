package org.evoloop.roomba.move;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.function.ToIntFunction;
import org.evoloop.roomba.move.phase.Maneuver;
import org.evoloop.roomba.oi.ActuatorCommand.DriveDirect;
import org.evoloop.roomba.oi.SensorValues;
import org.jspecify.annotations.Nullable;

/**
 * Whether the wheels turn as they are told, forward, backward or not at all, as their encoders show. A robot to which
 * no command comes through any more goes on with what it was told last, and nobody is told by the line: serial ports
 * take bytes that nobody reads.
 *
 * <p>Threading: thread-safe.
 */
final class ObeyWatch {
    private record Command(long nanos, DriveDirect wheels) {}

    private final long reactionNanos;
    private final long patienceNanos;
    private final long sampleNanos;
    private final Deque<Command> told = new ArrayDeque<>();
    private @Nullable SensorValues sample;
    private long sampledNanos;
    private boolean wrong;
    private long wrongNanos;
    private boolean reported;

    /**
     * @param frameLimitNanos how late what the robot does may show at a computer that is busy, 300 ms for a real robot
     */
    ObeyWatch(long frameLimitNanos) {
        this.reactionNanos = 2 * frameLimitNanos;
        this.patienceNanos = 3 * frameLimitNanos;
        this.sampleNanos = frameLimitNanos / 3;
    }

    /** The wheels were told this. */
    synchronized void told(DriveDirect wheels, long nanos) {
        told.addLast(new Command(nanos, wheels));
    }

    /**
     * Takes the next frame; true if it has become clear that the wheels turn otherwise than told. Only the first time.
     */
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
        forgetWhatIsOver(nanos);
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

    /** What was told last before counts as long as nothing else was. */
    private void forgetWhatIsOver(long nanos) {
        while (told.size() > 1) {
            Command first = told.removeFirst();
            if (nanos - told.getFirst().nanos() < reactionNanos) {
                told.addFirst(first);
                return;
            }
        }
    }

    /** Whether a wheel turns otherwise than by anything that it was told lately. */
    private boolean differs(ToIntFunction<DriveDirect> wheel, int counts) {
        // An encoder may stand on the edge of a count.
        int direction = Math.abs(counts) <= 1 ? 0 : Integer.signum(counts);
        for (Command each : told) {
            int speed = wheel.applyAsInt(each.wheels());
            boolean tooSlowToTell = speed != 0 && Math.abs(speed) < Maneuver.SLOWEST_MM_PER_S;
            if (tooSlowToTell || Integer.signum(speed) == direction) {
                return false;
            }
        }
        return !told.isEmpty();
    }
}
