package org.evoloop.roomba.session.inference;

import org.evoloop.roomba.oi.Packet;
import org.evoloop.roomba.oi.SensorValues;

/**
 * Accepts a change of buttons or mode only when two successive frames agree. The checksum of a frame has eight bits, so
 * on a noisy line a corrupt frame occasionally passes; a press lasts several frames, so a delay of one frame is
 * acceptable.
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

    /** @param modeOffset the offset of the robot's reported mode */
    public FrameFilter(ModeOffset modeOffset) {
        this.modeOffset = modeOffset;
    }

    /** The frame with the confirmed buttons and mode. */
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
