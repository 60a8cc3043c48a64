package org.evoloop.roomba.session.inference;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Set;
import org.evoloop.roomba.oi.Button;
import org.junit.jupiter.api.Test;

class ButtonPressesTest {
    private final ButtonPresses presses = new ButtonPresses();

    @Test
    void aButtonIsPressedOnceHoweverLongItIsHeld() {
        assertThat(presses.update(Set.of())).isEmpty();
        assertThat(presses.update(Set.of(Button.CLEAN))).containsExactly(Button.CLEAN);
        assertThat(presses.update(Set.of(Button.CLEAN))).isEmpty();
        assertThat(presses.update(Set.of())).isEmpty();
        assertThat(presses.update(Set.of(Button.CLEAN))).containsExactly(Button.CLEAN);
    }

    @Test
    void aSecondButtonIsReportedWhileTheFirstIsHeld() {
        presses.update(Set.of(Button.CLEAN));
        assertThat(presses.update(Set.of(Button.CLEAN, Button.SPOT))).containsExactly(Button.SPOT);
        assertThat(presses.update(Set.of(Button.SPOT))).isEmpty();
        assertThat(presses.update(Set.of(Button.CLEAN, Button.SPOT))).containsExactly(Button.CLEAN);
    }
}
