package org.evoloop.roomba.session.inference;

import java.util.EnumSet;
import java.util.Set;
import org.evoloop.roomba.oi.Button;

/**
 * Detects presses in packet 18, which only reports the buttons held down at the moment.
 *
 * <p>Threading: not thread-safe.
 *
 * @since 0.1
 */
public final class ButtonPresses {
    private Set<Button> held = EnumSet.noneOf(Button.class);

    /** No button is held. */
    public ButtonPresses() {}

    /** The buttons that have gone down since the last call. */
    public Set<Button> update(Set<Button> nowHeld) {
        Set<Button> pressed = EnumSet.noneOf(Button.class);
        pressed.addAll(nowHeld);
        pressed.removeAll(held);
        held = nowHeld;
        return pressed;
    }
}
