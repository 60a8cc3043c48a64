package org.evoloop.roomba.session.inference;

import org.evoloop.roomba.oi.Packet;
import org.evoloop.roomba.oi.SensorValues;

/**
 * Lets buttons and mode change only when two frames in a row agree. The checksum of a frame has eight bits, so that on
 * a noisy line a spoilt frame now and then passes; a press lasts several frames, so one frame later is soon enough.
 *
 * <p>Threading: not thread-safe.
 *
 * @since 0.1
 */
public final class FrameFilter {
    private final ModeOffset modeOffset;
    private int seenButtons;
    private int seenMode;
    private int buttons;
    private int mode;
    private boolean begun;

    /** @param modeOffset what the robot adds to its mode */
    public FrameFilter(ModeOffset modeOffset) {
        this.modeOffset = modeOffset;
    }

    /** The frame with the buttons and the mode that are to be believed. */
    public SensorValues filter(SensorValues values) {
        int nowButtons = values.value(Packet.BUTTONS);
        int nowMode = Math.max(0, values.value(Packet.OI_MODE) - modeOffset.value());
        if (!begun || nowButtons == seenButtons) {
            buttons = nowButtons;
        }
        if (!begun || nowMode == seenMode) {
            mode = nowMode;
        }
        begun = true;
        seenButtons = nowButtons;
        seenMode = nowMode;
        return values.with(Packet.BUTTONS, buttons).with(Packet.OI_MODE, mode);
    }
}
