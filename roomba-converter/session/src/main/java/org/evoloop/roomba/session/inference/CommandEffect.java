package org.evoloop.roomba.session.inference;

import org.evoloop.roomba.oi.Command;
import org.evoloop.roomba.oi.Packet;
import org.evoloop.roomba.oi.SensorValues;
import org.jspecify.annotations.Nullable;

/**
 * Detects the effect of a command from the OI mode, where the mode shows it: Safe and Full put a robot under control,
 * and commands that start work or switch it off end control. The effect on a robot that works by itself shows in its
 * motors, much later.
 *
 * <p>Threading: not thread-safe.
 *
 * @since 0.1
 */
public final class CommandEffect {
    /** The effect of a received command shows within this many frames: 0.24 s. */
    public static final int SHOW_FRAMES = 16;

    private final FrameSpan sinceCommand = new FrameSpan();
    private @Nullable Command awaited;
    private boolean over = true;
    private boolean missing;
    private boolean underControl;

    /** No effect is awaited. */
    public CommandEffect() {}

    /** A command is about to be sent. */
    public void sending(Command command) {
        if (takesControl(command) || command.opcode().endsControl()) {
            awaited = takesControl(command) == underControl ? null : command;
            missing = false;
            over = false;
            sinceCommand.restart();
        }
    }

    private static boolean takesControl(Command command) {
        return command instanceof Command.Safe || command instanceof Command.Full;
    }

    /**
     * Handles the next frame; returns the command whose effect it shows, else null.
     *
     * @param nowNanos the time on a monotonic clock
     */
    public @Nullable Command update(SensorValues values, boolean nowUnderControl, long nowNanos) {
        underControl = nowUnderControl;
        missing &= !underControl;
        sinceCommand.count(nowNanos);
        Command command = awaited;
        if (command != null && takesControl(command) == underControl) {
            awaited = null;
            over = true;
            return underControl || !leavesControlByItself(values) ? command : null;
        }
        if (!over && sinceCommand.hasLasted(SHOW_FRAMES)) {
            awaited = null;
            over = true;
            missing = command != null && takesControl(command);
        }
        return null;
    }

    /** Whether the robot leaves Safe mode without a command (specification, "Safe Mode"). */
    private static boolean leavesControlByItself(SensorValues values) {
        return values.anyWheelDrop() || values.anyCliff() || values.value(Packet.CHARGING_SOURCES) != 0;
    }

    /** Whether the effect of the last command has not been seen yet. */
    public boolean isAwaited() {
        return awaited != null;
    }

    /** Whether frames already show the time after the last command. */
    public boolean isOver() {
        return over;
    }

    /** Whether the last command should have put the robot under control, and that was never seen. */
    public boolean isMissing() {
        return missing;
    }
}
