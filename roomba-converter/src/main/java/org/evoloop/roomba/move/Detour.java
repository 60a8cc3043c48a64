package org.evoloop.roomba.move;

import org.evoloop.roomba.move.Situation.Obstacle;

/** Goes round an obstacle: back off, turn away from it, go on a little, and look around from there. */
final class Detour {
    /** Then the robot can turn freely, also where its front had got over an edge. */
    private static final double BACK_MM = 100;

    /** From the robot's centre to what it has touched, and a little beyond. */
    private static final double AHEAD_MM = 250;

    private static final double AWAY_RAD = Math.toRadians(65);

    /** From what is straight ahead, and from what is in the way of a detour. */
    private static final double FAR_AWAY_RAD = Math.toRadians(90);

    /** The robot's radius and more; each detour is longer than the one before, up to twice as long. */
    private static final double SHORTEST_MM = 300;

    private static final double LONGER_MM = 75;
    private static final int LONGEST = 4;

    /** So many in vain on one side, and the other side is tried as long. */
    private static final int PATIENCE = 3;

    private Detour() {}

    static Phase around(Phase phase, Situation now) {
        Memory memory = phase.memory();
        boolean again = phase instanceof Leg && memory.side() != 0;
        int side = again ? memory.side() : side(memory, now.obstacle());
        double away = again || now.obstacle() == Obstacle.AHEAD ? FAR_AWAY_RAD : AWAY_RAD;
        Memory wiser = memory.withDetour(side).avoiding(now.pose().beyond(AHEAD_MM, 0));
        Leg on = Leg.of(wiser, SHORTEST_MM + LONGER_MM * Math.min(LONGEST, memory.detours()), new Look.Around(wiser));
        return Leg.of(wiser, -BACK_MM, Turn.roughly(wiser, now.pose().headingRad() + side * away, on))
                .begun(now);
    }

    private static int side(Memory memory, Obstacle obstacle) {
        int other = memory.detours() / PATIENCE % 2 == 0 ? 1 : -1;
        return switch (obstacle) {
            case LEFT -> -other;
            case RIGHT -> other;
            case AHEAD, NONE -> memory.side() != 0 ? memory.side() * other : other;
        };
    }
}
