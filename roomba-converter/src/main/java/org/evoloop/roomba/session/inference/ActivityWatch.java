package org.evoloop.roomba.session.inference;

import org.evoloop.roomba.oi.SensorValues;
import org.jspecify.annotations.Nullable;

/**
 * Sees that the robot has begun to work or has come to rest while nobody controls its wheels, for whatever reason: its
 * schedule, a button that pauses it, an empty battery, being lifted.
 *
 * <p>Time is counted in frames, as in {@link SpotWatch}.
 *
 * <p>Threading: not thread-safe.
 */
public final class ActivityWatch {
    /** Motors that run for so long mean that the robot is at work: 0.5 s. */
    static final int WORK_FRAMES = 33;

    /** A robot that was told to work must show it within 3 s. */
    public static final int START_FRAMES = 200;

    /** What the robot does now. */
    public enum Seen {
        AT_WORK,
        AT_REST
    }

    private final Motion motion = new Motion();
    private boolean atWork;
    private int startFramesLeft;

    /** The robot was told to work. */
    public void expected() {
        startFramesLeft = START_FRAMES;
    }

    /** The robot was out of sight. */
    public void forget() {
        motion.forget();
        atWork = false;
        startFramesLeft = 0;
    }

    /** Takes the next frame; returns what the robot does if that has become clear now, else null. */
    public @Nullable Seen update(SensorValues values, boolean underControl) {
        motion.update(values);
        if (underControl) {
            // A command that ends control takes some frames to show: what is expected of it is not forgotten.
            atWork = false;
            return null;
        }
        if (motion.poweredFrames() >= SpotWatch.SURE_FRAMES) {
            atWork = true;
            startFramesLeft = 0;
        }
        boolean expectedInVain = startFramesLeft > 0 && --startFramesLeft == 0;
        if (expectedInVain || (atWork && motion.restFrames() >= SpotWatch.QUIET_FRAMES)) {
            atWork = false;
            return Seen.AT_REST;
        }
        return motion.poweredFrames() == WORK_FRAMES ? Seen.AT_WORK : null;
    }

    /** Whether motors have been running for so long that the robot must be at work. */
    public boolean isAtWork() {
        return motion.poweredFrames() >= WORK_FRAMES;
    }

    /** How many frames the robot has been at rest. */
    public int restFrames() {
        return motion.restFrames();
    }
}
