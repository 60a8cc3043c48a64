package org.evoloop.roomba.move.phase;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.evoloop.roomba.session.OdometryPose;

/** Chooses where to look around next. */
final class Wandering {
    private static final int DIRECTIONS = 16;
    private static final double STEP_MM = 100;
    private static final double LONGEST_MM = 1_200;

    /** Shorter legs are not worth driving, unless all are shorter. */
    private static final double SHORTEST_MM = 300;

    /** Penalty that makes a choice the last resort. */
    private static final double LAST_MM = 100_000;

    /** Beyond this distance from the places of failed searches, more distance has no value. */
    private static final double FAR_MM = 1_000;

    /** The robot's radius plus the uncertainty of an obstacle's place. */
    private static final double CLEAR_MM = 230;

    /**
     * One mm farther from the goal costs as much as this many mm nearer to a station. Before the goal was first seen,
     * it is assumed to be where Move began: the owner starts Move near the starting point.
     */
    private static final double ASTRAY = 0.3;

    private record Choice(double headingRad, double lengthMm, double worthMm) {}

    private Wandering() {}

    /**
     * Turns, drives as far as no known obstacle is in the way, and looks around there.
     *
     * @param goal where it was last seen
     */
    static Phase on(Memory memory, OdometryPose pose, Optional<OdometryPose> goal) {
        OdometryPose home =
                goal.or(() -> memory.stations().stream().findFirst()).orElse(pose);
        Choice best = IntStream.range(0, DIRECTIONS)
                .mapToObj(which -> choice(memory, pose, home, 2 * Math.PI * which / DIRECTIONS))
                .max(Comparator.comparingDouble(Choice::worthMm))
                .orElseThrow();
        return Turn.roughly(
                memory,
                best.headingRad(),
                Leg.of(memory, best.lengthMm(), new Look.Around(memory)).alertly());
    }

    private static Choice choice(Memory memory, OdometryPose pose, OdometryPose home, double bearingRad) {
        double lengthMm = STEP_MM;
        while (lengthMm < LONGEST_MM
                && nearest(memory.obstacles(), pose.beyond(lengthMm + STEP_MM, bearingRad)) > CLEAR_MM) {
            lengthMm += STEP_MM;
        }
        OdometryPose end = pose.beyond(lengthMm, bearingRad);
        double worthMm =
                Math.min(FAR_MM, nearest(memory.stations(), end)) - ASTRAY * end.distanceTo(home.xMm(), home.yMm());
        return new Choice(
                end.headingRad(),
                Math.max(SHORTEST_MM, lengthMm),
                lengthMm < SHORTEST_MM ? lengthMm - LAST_MM : worthMm);
    }

    private static double nearest(List<OdometryPose> places, OdometryPose end) {
        return places.stream()
                .mapToDouble(place -> end.distanceTo(place.xMm(), place.yMm()))
                .min()
                .orElse(Double.POSITIVE_INFINITY);
    }
}
