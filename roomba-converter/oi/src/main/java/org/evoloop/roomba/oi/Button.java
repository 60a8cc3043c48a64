package org.evoloop.roomba.oi;

import java.util.EnumSet;
import java.util.Set;

/**
 * The buttons on top of the robot, with their bits in {@link Packet#BUTTONS} and {@link ActuatorCommand.Buttons}.
 * Robots without a clock have the first three only.
 */
public enum Button {
    CLEAN(0),
    SPOT(1),
    DOCK(2),
    MINUTE(3),
    HOUR(4),
    DAY(5),
    SCHEDULE(6),
    CLOCK(7);

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

    /** The buttons whose bits are set; a set of the caller's own. */
    public static Set<Button> fromBits(int bits) {
        Set<Button> buttons = EnumSet.noneOf(Button.class);
        for (Button button : values()) {
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
