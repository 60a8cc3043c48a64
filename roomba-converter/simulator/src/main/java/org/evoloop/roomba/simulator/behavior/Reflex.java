package org.evoloop.roomba.simulator.behavior;

import java.util.EnumSet;
import java.util.Set;
import org.evoloop.roomba.simulator.body.Body;
import org.evoloop.roomba.simulator.body.CliffSensor;
import org.evoloop.roomba.simulator.body.Side;
import org.evoloop.roomba.simulator.body.Surroundings;

/** Takes precedence over every plan: backs off from obstacles and cliffs, and turns away. */
final class Reflex {
    private static final int BACK_TICKS = 30;
    private static final double BACK_MM_PER_S = 150;
    private static final int SHORTEST_TURN_TICKS = 40;
    private static final int MORE_TURN_TICKS = 80;

    /** Turns that are this part of their range longer than the last never repeat, nor come close to it soon. */
    private static final double GOLDEN_SHARE = 0.618;

    /** A shorter time between two reflexes means that the first did not help. */
    private static final int HELPED_TICKS = 30;

    /** After this many reflexes in a row that did not help, the robot is stuck. */
    private static final int HOPELESS = 12;

    private int backTicks;
    private int turnTicks;
    private double turn = 1;
    private int calmTicks = HELPED_TICKS;
    private int inVain;
    private int count;

    /** Sets the wheels if there is an obstacle or a cliff; returns whether there was. */
    boolean steer(Body body) {
        Set<Side> hit = hit(body.surroundings());
        if (backTicks == 0 && !hit.isEmpty()) {
            begin(hit);
        }
        if (backTicks > 0) {
            backTicks--;
            body.drive(-BACK_MM_PER_S, -BACK_MM_PER_S);
        } else if (turnTicks > 0) {
            turnTicks--;
            Pursuit.spin(body, turn);
        } else {
            calmTicks++;
            return false;
        }
        return true;
    }

    private static Set<Side> hit(Surroundings surroundings) {
        Set<Side> hit = EnumSet.noneOf(Side.class);
        hit.addAll(surroundings.bumps());
        for (CliffSensor cliff : surroundings.cliffs()) {
            hit.add(cliff == CliffSensor.LEFT || cliff == CliffSensor.FRONT_LEFT ? Side.LEFT : Side.RIGHT);
        }
        return hit;
    }

    private void begin(Set<Side> hit) {
        inVain = calmTicks < HELPED_TICKS ? inVain + 1 : 0;
        calmTicks = 0;
        count++;
        backTicks = BACK_TICKS;
        turnTicks = SHORTEST_TURN_TICKS + (int) (MORE_TURN_TICKS * (count * GOLDEN_SHARE % 1));
        if (hit.size() == 1) {
            turn = hit.contains(Side.LEFT) ? -1 : 1;
        }
    }

    /** Whether there is an obstacle or a cliff now. */
    static boolean isNeeded(Body body) {
        return !hit(body.surroundings()).isEmpty();
    }

    /** Whether repeated reflexes did not help. */
    boolean isStuck() {
        return inVain >= HOPELESS;
    }
}
