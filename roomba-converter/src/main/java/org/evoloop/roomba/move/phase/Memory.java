package org.evoloop.roomba.move.phase;

import java.time.Duration;
import java.util.List;
import java.util.stream.Stream;
import org.evoloop.roomba.session.OdometryPose;

/**
 * What Move remembers from phase to phase; places are in odometry coordinates.
 *
 * <p>Threading: immutable.
 *
 * @param target which distance from the goal counts as arrived
 * @param frameLimit the wheels stop when the newest look is older than this
 * @param settle this long after a stop command, pictures show the robot at rest
 * @param stations where the robot looked around without success, oldest first
 * @param obstacles where something was in the way
 * @param side on which the robot went round the last obstacle: 1 left, -1 right, 0 if there was none
 * @param inARow how many obstacles were in the way since the robot last saw the goal or looked around for it
 */
public record Memory(
        Target target,
        Duration frameLimit,
        Duration settle,
        List<OdometryPose> stations,
        List<OdometryPose> obstacles,
        int side,
        int inARow) {
    /** The goal is lost after this many frame limits without a sighting: after 0.6 s, or 50 mm. */
    private static final int LOST_FRAMES = 2;

    /** The memory at the beginning. */
    public Memory(Target target, Duration frameLimit, Duration settle) {
        this(target, frameLimit, settle, List.of(), List.of(), 0, 0);
    }

    Memory withStation(OdometryPose place) {
        return new Memory(target, frameLimit, settle, and(stations, place), obstacles, side, 0);
    }

    /** Adds an obstacle that is not in the way now. */
    Memory withObstacle(OdometryPose place) {
        return new Memory(target, frameLimit, settle, stations, and(obstacles, place), side, inARow);
    }

    /** Adds an obstacle that is in the way; the robot goes round it on this side. */
    Memory withDetour(OdometryPose place, int newSide) {
        return new Memory(target, frameLimit, settle, stations, and(obstacles, place), newSide, inARow + 1);
    }

    /** The goal is in sight if it was seen at this moment or later. */
    long seenSince(Situation now) {
        return now.nanos() - LOST_FRAMES * frameLimit.toNanos();
    }

    private static List<OdometryPose> and(List<OdometryPose> places, OdometryPose more) {
        return Stream.concat(places.stream(), Stream.of(more)).toList();
    }
}
