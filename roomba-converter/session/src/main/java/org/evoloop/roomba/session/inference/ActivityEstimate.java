package org.evoloop.roomba.session.inference;

import org.evoloop.roomba.oi.Button;
import org.evoloop.roomba.oi.Command;
import org.evoloop.roomba.oi.SensorValues;

/**
 * Estimates the robot's own activity by the rules of its firmware: while it works, each of its buttons pauses it; while
 * it is on and idle, a button starts the work it is named after; in standby, CLEAN only switches it on. While the robot
 * is not under control, its motors correct the estimate after other causes: its schedule, an empty battery, being
 * lifted.
 *
 * <p>Time is counted as in {@link SpotWatch}.
 *
 * <p>Threading: not thread-safe.
 *
 * @since 0.1
 */
public final class ActivityEstimate {
    /** If motors run for this long, the robot is at work: 0.5 s. */
    static final int WORK_FRAMES = 33;

    /** A robot that was commanded to work must show it within 3 s. */
    public static final int START_FRAMES = 200;

    /** If a cleaning robot drives with its brushes at rest for this long, it is returning to its dock: 3 s. */
    static final int HOMEWARD_FRAMES = 200;

    /** The estimated activity. */
    public enum EstimatedActivity {
        /** Idle; its light is off. */
        STANDBY,
        /** Idle and on. */
        ON,
        /** Cleans. */
        CLEAN,
        /** Cleans until the battery is empty; from outside that looks like {@link #CLEAN}. */
        MAX,
        /** Cleans a spot. */
        SPOT,
        /** Looking for its dock. */
        DOCK;

        /** Whether the robot moves by itself. */
        public boolean isWork() {
            return this != STANDBY && this != ON;
        }
    }

    private final Motion motion = new Motion();
    private EstimatedActivity activity = EstimatedActivity.STANDBY;
    private boolean atWork;
    private final FrameSpan sinceStart = new FrameSpan();
    private boolean startExpected;
    private final FrameSpan sincePause = new FrameSpan();
    private boolean deaf;

    /** Before any command and any frame. */
    public ActivityEstimate() {}

    /** The estimate after the frames so far. */
    public EstimatedActivity activity() {
        return activity;
    }

    /** Sets the activity last reported to another process; the motors show within 3 s whether it continues. */
    public void assume(EstimatedActivity last) {
        forget();
        activity = last;
        if (last.isWork()) {
            expectStart();
        }
    }

    private void expectStart() {
        startExpected = true;
        sinceStart.restart();
    }

    /** One of its buttons was pressed while it was not under control. */
    public void pressed(Button button) {
        if (activity.isWork()) {
            if (button == Button.CLEAN || button == Button.SPOT || button == Button.DOCK) {
                activity = EstimatedActivity.ON;
            }
        } else if (activity == EstimatedActivity.STANDBY) {
            activity = button == Button.CLEAN ? EstimatedActivity.ON : EstimatedActivity.STANDBY;
        } else {
            activity = switch (button) {
                case CLEAN -> EstimatedActivity.CLEAN;
                case SPOT -> EstimatedActivity.SPOT;
                case DOCK -> EstimatedActivity.DOCK;
                default -> activity;
            };
        }
        // Earlier motor activity says nothing about the effect of the press.
        forget();
        if (activity.isWork()) {
            expectStart();
        }
    }

    /** A command was sent; one that starts work pauses a robot that is at work. */
    public void commanded(Command command) {
        if (command instanceof Command.Safe || command instanceof Command.Full) {
            activity = EstimatedActivity.ON;
        } else if (command instanceof Command.Power) {
            activity = EstimatedActivity.STANDBY;
            startExpected = false;
        } else if (command.opcode().startsWork()) {
            // Until the pause takes effect, the motors show the earlier activity.
            deaf = activity.isWork();
            sincePause.restart();
            activity = activity.isWork() ? EstimatedActivity.ON : begunBy(command);
            expectStart();
        }
    }

    private static EstimatedActivity begunBy(Command command) {
        return switch (command.opcode()) {
            case SPOT -> EstimatedActivity.SPOT;
            case MAX -> EstimatedActivity.MAX;
            case SEEK_DOCK -> EstimatedActivity.DOCK;
            default -> EstimatedActivity.CLEAN;
        };
    }

    /** It is under control: its own activity has ended. */
    public void controlled() {
        activity = EstimatedActivity.ON;
    }

    /** It has come to rest, or never started. */
    public void seenAtRest() {
        if (activity.isWork()) {
            activity = EstimatedActivity.ON;
        }
    }

    /** It has fallen asleep, so its light is off, and CLEAN only switches it on. */
    public void fellAsleep() {
        activity = EstimatedActivity.STANDBY;
    }

    /** Forgets earlier frames, since the robot was unreachable. */
    public void forget() {
        motion.forget();
        atWork = false;
        startExpected = false;
    }

    /**
     * Handles the next frame.
     *
     * @param workIsNews whether work should be reported; not if it is about to be ended
     * @param nowNanos the time on a monotonic clock
     * @return whether the robot's activity was observed just now; it may be known already
     */
    public boolean update(SensorValues values, boolean underControl, boolean workIsNews, long nowNanos) {
        motion.update(values);
        if (deaf) {
            motion.forget();
            sincePause.count(nowNanos);
            deaf = !sincePause.hasLasted(CommandEffect.SHOW_FRAMES);
        }
        if (underControl) {
            // A command that ends control takes some frames to show; keep its expected effect.
            atWork = false;
            return false;
        }
        if (motion.poweredFrames() >= SpotWatch.SURE_FRAMES) {
            atWork = true;
            startExpected = false;
        }
        sinceStart.count(nowNanos);
        boolean expectedInVain = startExpected && sinceStart.hasLasted(START_FRAMES);
        startExpected &= !expectedInVain;
        if (expectedInVain || (atWork && isAtRest())) {
            atWork = false;
            seenAtRest();
            return true;
        }
        if ((activity == EstimatedActivity.CLEAN || activity == EstimatedActivity.MAX)
                && motion.brushlessFrames() >= HOMEWARD_FRAMES) {
            activity = EstimatedActivity.DOCK;
            return true;
        }
        boolean begun = motion.poweredFrames() == WORK_FRAMES && workIsNews;
        if (begun && !activity.isWork()) {
            // Without a known cause the robot is cleaning, for example by its schedule.
            activity = EstimatedActivity.CLEAN;
        }
        return begun;
    }

    /** Whether its motors confirm the estimate. */
    public boolean isSure() {
        return activity.isWork() ? isAtWork() : isAtRest();
    }

    /** Whether its motors show that the robot is at work, whatever its mode. */
    public boolean isAtWork() {
        return motion.poweredFrames() >= WORK_FRAMES;
    }

    /** Whether the robot has been at rest for a while. */
    public boolean isAtRest() {
        return motion.restFrames() >= SpotWatch.QUIET_FRAMES;
    }
}
