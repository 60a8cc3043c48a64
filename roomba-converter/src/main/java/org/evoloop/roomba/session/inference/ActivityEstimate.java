package org.evoloop.roomba.session.inference;

import org.evoloop.roomba.oi.Button;
import org.evoloop.roomba.oi.Command;

/**
 * What the robot does by itself, followed by the rules of its firmware: at work, each of its buttons pauses it; on and
 * idle, they start what they are named after; in standby CLEAN only switches it on. What is seen of its motors corrects
 * the estimate.
 *
 * <p>Threading: not thread-safe.
 */
public final class ActivityEstimate {

    /** What the robot is taken to do. */
    public enum Activity {
        STANDBY,
        ON,
        CLEAN,
        SPOT,
        /** Looking for its dock. */
        DOCK;

        public boolean isWork() {
            return this == CLEAN || this == SPOT || this == DOCK;
        }
    }

    private Activity activity = Activity.STANDBY;

    public Activity activity() {
        return activity;
    }

    /** One of its buttons was pressed while nobody controls it. */
    public void pressed(Button button) {
        if (activity.isWork()) {
            if (button == Button.CLEAN || button == Button.SPOT || button == Button.DOCK) {
                activity = Activity.ON;
            }
        } else if (activity == Activity.STANDBY) {
            activity = button == Button.CLEAN ? Activity.ON : Activity.STANDBY;
        } else {
            activity = switch (button) {
                case CLEAN -> Activity.CLEAN;
                case SPOT -> Activity.SPOT;
                case DOCK -> Activity.DOCK;
                default -> activity;
            };
        }
    }

    /** A command was sent; one that starts work pauses a robot that is at work. */
    public void commanded(Command command) {
        if (command instanceof Command.Safe || command instanceof Command.Full) {
            activity = Activity.ON;
        } else if (command instanceof Command.Clean || command instanceof Command.Spot) {
            Activity wanted = command instanceof Command.Clean ? Activity.CLEAN : Activity.SPOT;
            activity = activity.isWork() ? Activity.ON : wanted;
        }
    }

    /** It is under control: whatever it did has ended. */
    public void controlled() {
        activity = Activity.ON;
    }

    /** It has come to rest, or never began. */
    public void seenAtRest() {
        if (activity.isWork()) {
            activity = Activity.ON;
        }
    }

    /** Its motors run: if it was not known to be at work, it cleans, as by its schedule. */
    public void seenAtWork() {
        if (!activity.isWork()) {
            activity = Activity.CLEAN;
        }
    }
}
