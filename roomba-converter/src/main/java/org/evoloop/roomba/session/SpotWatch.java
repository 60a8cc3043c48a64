package org.evoloop.roomba.session;

import org.evoloop.roomba.oi.OiMode;
import org.evoloop.roomba.oi.SensorValues;
import org.jspecify.annotations.Nullable;

/**
 * Infers when a spot cleaning has ended, which no packet of the Open Interface tells: the robot starts to move or its
 * brushes to draw current, and later all of it has been quiet for a while.
 *
 * <p>Time is counted in frames of the stream, one every 15 ms: the robot's own clock, which no delay on the way can
 * distort. Lost frames make it late, never early.
 *
 * <p>Threading: not thread-safe.
 */
public final class SpotWatch {
    /** How long after its start a spot cleaning must show: 3 s. */
    static final int START_FRAMES = 200;

    /** How long all must be quiet: 1 s. A spiral never stops the wheels that long, a turn after a bump may take less. */
    static final int QUIET_FRAMES = 67;

    /** No spot cleaning lasts longer: 180 s. */
    static final int LONGEST_FRAMES = 12_000;

    /** Less flows into the battery, in mA, while motors run; at rest it is about -200. */
    static final int MOVING_CURRENT_MILLI_AMPS = -300;

    /** More flows through a brush motor, in mA, while it turns. */
    static final int BRUSH_CURRENT_MILLI_AMPS = 20;

    /** At rest for this long the robot is taken to do nothing: 0.3 s. */
    static final int REST_FRAMES = 20;

    /** How a spot cleaning came to its end. */
    public enum Ending {
        /** The robot finished, or was paused by its user. */
        QUIET,
        /** The robot never began. */
        NOT_STARTED,
        /** The mode has changed, which ends whatever the robot did by itself. */
        OVERRIDDEN,
        /** It cannot have lasted as long as this. */
        TOO_LONG
    }

    private enum Phase {
        NONE,
        STARTING,
        RUNNING
    }

    private Phase phase = Phase.NONE;
    private int frames;
    private int quietFrames;
    private int restFrames = REST_FRAMES;
    private @Nullable SensorValues last;

    /** A spot cleaning was asked for, by a command or by the robot's own button. */
    public void started() {
        phase = Phase.STARTING;
        frames = 0;
        quietFrames = 0;
    }

    /** Whether the robot has moved or cleaned of late: then its SPOT button pauses it, else it starts a spot cleaning. */
    public boolean isRobotActive() {
        return restFrames < REST_FRAMES;
    }

    private boolean isActive(SensorValues values) {
        SensorValues earlier = last;
        boolean turned = earlier != null
                && (earlier.leftEncoderCounts() != values.leftEncoderCounts()
                        || earlier.rightEncoderCounts() != values.rightEncoderCounts());
        return turned
                || values.currentMilliAmps() < MOVING_CURRENT_MILLI_AMPS
                || Math.abs(values.mainBrushMilliAmps()) > BRUSH_CURRENT_MILLI_AMPS
                || Math.abs(values.sideBrushMilliAmps()) > BRUSH_CURRENT_MILLI_AMPS;
    }

    /** Takes the next frame; returns how the spot cleaning ended if it has ended now, else null. */
    public @Nullable Ending update(SensorValues values) {
        boolean active = isActive(values);
        last = values;
        restFrames = active ? 0 : restFrames + 1;
        if (phase == Phase.NONE) {
            return null;
        }
        frames++;
        quietFrames = active ? 0 : quietFrames + 1;
        if (phase == Phase.STARTING && active && isPassive(values)) {
            phase = Phase.RUNNING;
        }
        Ending ending = ending(values);
        if (ending != null) {
            phase = Phase.NONE;
        }
        return ending;
    }

    private @Nullable Ending ending(SensorValues values) {
        if (phase == Phase.STARTING) {
            return frames >= START_FRAMES ? Ending.NOT_STARTED : null;
        }
        if (!isPassive(values)) {
            return Ending.OVERRIDDEN;
        }
        if (quietFrames >= QUIET_FRAMES) {
            return Ending.QUIET;
        }
        return frames >= LONGEST_FRAMES ? Ending.TOO_LONG : null;
    }

    private static boolean isPassive(SensorValues values) {
        return values.mode().filter(OiMode.PASSIVE::equals).isPresent();
    }
}
