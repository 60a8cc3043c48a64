package org.evoloop.roomba.session.inference;

import org.evoloop.roomba.oi.Command;
import org.evoloop.roomba.oi.Packet;
import org.evoloop.roomba.oi.SensorValues;
import org.jspecify.annotations.Nullable;

/**
 * Sees in the OI mode that a command has had its effect, where the mode shows it: Safe and Full put a robot under
 * control, and what starts work or switches off ends that. What a command does to a robot that works by itself shows in
 * its motors, much later.
 *
 * <p>Time is counted in frames of the stream, one every 15 ms.
 *
 * <p>Threading: not thread-safe.
 *
 * @since 0.1
 */
public final class CommandEffect {
    /** A command that has arrived shows within so many frames: 0.24 s. */
    public static final int SHOW_FRAMES = 16;

    private @Nullable Command awaited;
    private int frames = SHOW_FRAMES;
    private boolean missing;
    private boolean underControl;

    /** No command is awaited. */
    public CommandEffect() {}

    /** A command is about to be sent. */
    public void sending(Command command) {
        if (takesControl(command) || command.opcode().endsControl()) {
            awaited = takesControl(command) == underControl ? null : command;
            missing = false;
            frames = 0;
        }
    }

    private static boolean takesControl(Command command) {
        return command instanceof Command.Safe || command instanceof Command.Full;
    }

    /** Takes the next frame; returns the command whose effect it shows, else null. */
    public @Nullable Command update(SensorValues values, boolean nowUnderControl) {
        underControl = nowUnderControl;
        missing &= !underControl;
        frames++;
        Command command = awaited;
        if (command == null) {
            return null;
        }
        if (takesControl(command) == underControl) {
            awaited = null;
            frames = SHOW_FRAMES;
            return underControl || !leavesControlByItself(values) ? command : null;
        }
        if (frames >= SHOW_FRAMES) {
            awaited = null;
            missing = takesControl(command);
        }
        return null;
    }

    /** What ends Safe mode without any command (specification, "Safe Mode"). */
    private static boolean leavesControlByItself(SensorValues values) {
        return values.anyWheelDrop() || values.anyCliff() || values.value(Packet.CHARGING_SOURCES) != 0;
    }

    /** Whether the effect of the last command is still to be seen. */
    public boolean isAwaited() {
        return awaited != null;
    }

    /** Whether frames tell of the time after the last command. */
    public boolean isOver() {
        return frames >= SHOW_FRAMES;
    }

    /** Whether the last command should have put the robot under control, and that was never seen. */
    public boolean isMissing() {
        return missing;
    }
}
