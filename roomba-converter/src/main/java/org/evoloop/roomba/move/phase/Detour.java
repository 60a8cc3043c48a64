package org.evoloop.roomba.move.phase;

import java.util.Optional;
import org.evoloop.roomba.move.phase.Situation.Obstacle;
import org.evoloop.roomba.session.OdometryPose;

/** Drives round an obstacle: back off, turn away from it, drive a short way, and look around from there. */
final class Detour {
    /** After this the robot can turn freely, even if its front was over an edge. */
    private static final double BACK_MM = 100;

    /** From the robot's centre to a touched obstacle, and a little beyond. */
    private static final double AHEAD_MM = 250;

    private static final double AWAY_RAD = Math.toRadians(65);

    /** The turn for an obstacle straight ahead, or for one met during a detour. */
    private static final double FAR_AWAY_RAD = Math.toRadians(90);

    /** The robot's radius and more; each further detour is longer, up to twice as long. */
    private static final double SHORTEST_MM = 300;

    private static final double LONGER_MM = 75;
    private static final int LONGEST = 4;

    /** After this many obstacles the other side is preferred, for as many. */
    private static final int PATIENCE = 3;

    private Detour() {}

    static Phase around(Phase phase, Situation now) {
        Memory memory = phase.memory();
        OdometryPose place = now.pose().beyond(AHEAD_MM, Math.toRadians(45) * bearing(now.obstacle()));
        boolean again = phase instanceof Leg && memory.side() != 0;
        int side = again ? memory.side() : side(memory, now.obstacle());
        Memory updated = memory.withDetour(place, side);
        return Leg.of(updated, -BACK_MM, onwards(updated, now, again)).begun(now);
    }

    private static Phase onwards(Memory updated, Situation now, boolean again) {
        if (now.sight().goal().isEmpty() && !now.edge()) {
            return Wandering.on(updated, now.pose().beyond(-BACK_MM, 0), Optional.empty());
        }
        double away = again || now.obstacle() == Obstacle.AHEAD ? FAR_AWAY_RAD : AWAY_RAD;
        return Turn.roughly(
                updated,
                now.pose().headingRad() + updated.side() * away,
                Leg.of(
                        updated,
                        SHORTEST_MM + LONGER_MM * Math.min(LONGEST, updated.inARow()),
                        new Look.Around(updated)));
    }

    private static int bearing(Obstacle obstacle) {
        return obstacle == Obstacle.LEFT ? 1 : obstacle == Obstacle.RIGHT ? -1 : 0;
    }

    private static int side(Memory memory, Obstacle obstacle) {
        int other = memory.obstacles().size() / PATIENCE % 2 == 0 ? 1 : -1;
        return switch (obstacle) {
            case LEFT -> -other;
            case RIGHT -> other;
            case AHEAD, NONE -> memory.side() != 0 ? memory.side() * other : other;
        };
    }
}
