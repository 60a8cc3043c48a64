package org.evoloop.roomba.simulator.robot;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.EnumMap;
import java.util.EnumSet;
import java.util.Map;
import java.util.Set;
import org.evoloop.roomba.oi.Button;
import org.evoloop.roomba.simulator.body.Body;

/** The buttons held down, the remaining time of each, and the presses that wait until their button is released. */
final class ButtonPanel {
    /** The shortest time between two presses of a button: 90 ms. */
    static final int RELEASED_TICKS = 6;

    private record Phase(boolean down, int ticks) {}

    private final Map<Button, Deque<Phase>> plans = new EnumMap<>(Button.class);

    /**
     * A person presses a button. If it is still down, or was just released, this press is queued.
     *
     * @return whether it went down now; if not, {@link #tick()} reports it later
     */
    boolean press(Button button, int durationMillis) {
        Deque<Phase> plan = plan(button);
        boolean now = plan.isEmpty();
        plan.add(new Phase(true, ticks(durationMillis)));
        plan.add(new Phase(false, RELEASED_TICKS));
        return now;
    }

    /**
     * A client holds a button down.
     *
     * @return whether it went down; false if it was down already and is just held on
     */
    boolean hold(Button button, int durationMillis) {
        Deque<Phase> plan = plan(button);
        boolean wasDown = isDown(plan);
        if (wasDown) {
            plan.removeFirst();
        }
        plan.addFirst(new Phase(true, ticks(durationMillis)));
        return !wasDown;
    }

    private Deque<Phase> plan(Button button) {
        return plans.computeIfAbsent(button, none -> new ArrayDeque<>());
    }

    private static int ticks(int durationMillis) {
        return Math.max(1, (durationMillis + Body.TICK_MILLIS - 1) / Body.TICK_MILLIS);
    }

    private static boolean isDown(Deque<Phase> plan) {
        return !plan.isEmpty() && plan.getFirst().down();
    }

    /** Advances by one tick; returns the buttons that went down in it. */
    Set<Button> tick() {
        Set<Button> before = pressed();
        plans.values().forEach(ButtonPanel::tick);
        Set<Button> now = pressed();
        now.removeAll(before);
        return now;
    }

    private static void tick(Deque<Phase> plan) {
        Phase current = plan.poll();
        if (current != null && current.ticks() > 1) {
            plan.addFirst(new Phase(current.down(), current.ticks() - 1));
        }
    }

    /** The buttons that are down. */
    Set<Button> pressed() {
        Set<Button> down = EnumSet.noneOf(Button.class);
        plans.forEach((button, plan) -> {
            if (isDown(plan)) {
                down.add(button);
            }
        });
        return down;
    }
}
