package org.evoloop.roomba.simulator.robot;

import java.util.EnumMap;
import java.util.Map;
import java.util.Set;
import org.evoloop.roomba.oi.Button;
import org.evoloop.roomba.simulator.body.Body;

/** Which buttons are held down, and for how long yet. */
final class ButtonPanel {
    private final Map<Button, Integer> ticksLeft = new EnumMap<>(Button.class);

    /**
     * Holds a button down for the ticks to come, at least one.
     *
     * @return whether it went down; false if it was held already and is just held on
     */
    boolean press(Button button, int durationMillis) {
        int ticks = Math.max(1, (durationMillis + Body.TICK_MILLIS - 1) / Body.TICK_MILLIS);
        return ticksLeft.put(button, ticks) == null;
    }

    void tick() {
        ticksLeft.replaceAll((button, ticks) -> ticks - 1);
        ticksLeft.values().removeIf(ticks -> ticks == 0);
    }

    Set<Button> pressed() {
        return ticksLeft.keySet();
    }
}
