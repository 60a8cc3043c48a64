package org.evoloop.roomba.session.inference;

import org.evoloop.roomba.oi.OiMode;
import org.evoloop.roomba.oi.SensorValues;
import org.jspecify.annotations.Nullable;

/**
 * Infers the end of a spot cleaning, which no packet of the Open Interface shows: the robot starts to move or its
 * brushes to draw current, and later everything has been at rest for a while.
 *
 * <p>Time is counted in frames of the stream, one every 15 ms: the robot's own clock, which transmission delays do not
 * distort. Lost frames delay the result, but never make it early. Only the time since a command also needs a {@link
 * FrameSpan}, since earlier frames may come after it.
 *
 * <p>Threading: not thread-safe.
 *
 * @since 0.1
 */
public final class SpotWatch {
    /** How long after its start a spot cleaning must show: 3 s. */
    static final int START_FRAMES = 200;

    /**
     * How long everything must be at rest: 1 s. A spiral never stops the wheels that long, a turn after a bump is
     * shorter.
     */
    public static final int QUIET_FRAMES = 67;

    /** The longest spot cleaning: 180 s. */
    static final int LONGEST_FRAMES = 12_000;

    /** The number of frames in a row that must agree; a single one may be corrupt. */
    static final int SURE_FRAMES = 3;

    /** How a spot cleaning ended. */
    public enum SpotEnd {
        /** The robot finished, or was paused by its user. */
        QUIET,
        /** The robot never started. */
        NOT_STARTED,
        /** The mode has changed, which ends the robot's own activity. */
        OVERRIDDEN,
        /** It exceeded the longest possible duration. */
        TOO_LONG
    }

    private enum Phase {
        NONE,
        STARTING,
        RUNNING
    }

    private final Motion motion = new Motion();
    private Phase phase = Phase.NONE;
    private final FrameSpan sinceStart = new FrameSpan();

    /** Before any command and any frame. */
    public SpotWatch() {}

    /** A spot cleaning was started, by a command or by the robot's own button. */
    public void started() {
        phase = Phase.STARTING;
        sinceStart.restart();
    }

    /** Forgets the spot cleaning: the robot was unreachable, or does something else. */
    public void forget() {
        phase = Phase.NONE;
    }

    /**
     * Handles the next frame; returns how the spot cleaning ended if it has ended now, else null.
     *
     * @param nowNanos the time on a monotonic clock
     */
    public @Nullable SpotEnd update(SensorValues values, long nowNanos) {
        motion.update(values);
        if (phase == Phase.NONE) {
            return null;
        }
        sinceStart.count(nowNanos);
        if (phase == Phase.STARTING && motion.activeFrames() >= SURE_FRAMES && isPassive(values)) {
            phase = Phase.RUNNING;
        }
        SpotEnd ending = ending(values);
        if (ending != null) {
            phase = Phase.NONE;
        }
        return ending;
    }

    private @Nullable SpotEnd ending(SensorValues values) {
        if (phase == Phase.STARTING) {
            return sinceStart.hasLasted(START_FRAMES) ? SpotEnd.NOT_STARTED : null;
        }
        if (!isPassive(values)) {
            return SpotEnd.OVERRIDDEN;
        }
        if (motion.restFrames() >= QUIET_FRAMES) {
            return SpotEnd.QUIET;
        }
        return sinceStart.hasLasted(LONGEST_FRAMES) ? SpotEnd.TOO_LONG : null;
    }

    private static boolean isPassive(SensorValues values) {
        return values.mode().filter(OiMode.PASSIVE::equals).isPresent();
    }
}
