package org.evoloop.roomba.oi;

import java.util.EnumSet;
import java.util.Set;

/**
 * The buttons on top of the robot, with their bits in {@link Packet#BUTTONS} and {@link ActuatorCommand.Buttons}.
 * Robots without a clock have the first three only.
 *
 * @since 0.1
 */
public enum Button {
    /** Cleans, or wakes the robot. */
    CLEAN(0),
    /** Cleans the spot where the robot is. */
    SPOT(1),
    /** Sends the robot to its dock. */
    DOCK(2),
    /** Sets the minutes of clock and schedule. */
    MINUTE(3),
    /** Sets the hours of clock and schedule. */
    HOUR(4),
    /** Sets the day of clock and schedule. */
    DAY(5),
    /** Sets the schedule. */
    SCHEDULE(6),
    /** Sets the clock. */
    CLOCK(7);

    /** Read in each frame; {@link #values()} makes a copy at each call. */
    private static final Button[] ALL = values();

    private final int bit;

    Button(int bit) {
        this.bit = bit;
    }

    /** The number of this button's bit, 0 to 7. */
    public int bit() {
        return bit;
    }

    /** Whether this button's bit is set. */
    public boolean isIn(int bits) {
        return Bytes.hasBit(bits, bit);
    }

    /** The buttons whose bits are set, as a new set. */
    public static Set<Button> fromBits(int bits) {
        Set<Button> buttons = EnumSet.noneOf(Button.class);
        for (Button button : ALL) {
            if (button.isIn(bits)) {
                buttons.add(button);
            }
        }
        return buttons;
    }

    /** One byte with the bits of these buttons. */
    public static int toBits(Set<Button> buttons) {
        int bits = 0;
        for (Button button : buttons) {
            bits |= 1 << button.bit;
        }
        return bits;
    }
}
