package org.evoloop.roomba.move.phase;

import java.time.Duration;
import java.util.List;
import java.util.stream.Stream;
import org.evoloop.roomba.session.OdometryPose;

/**
 * What Move remembers from phase to phase; places are in the coordinates of the robot's wheels.
 *
 * <p>Threading: immutable.
 *
 * @param target where the robot has arrived
 * @param frameLimit the wheels stop when the newest look is older than this
 * @param settle so long after the robot was told to stop, what is seen was taken at rest
 * @param stations where the robot looked around in vain, the first one first
 * @param obstacles where something was in the way
 * @param side to which the last obstacle was gone round: 1 left, -1 right, 0 if there was none
 * @param inARow how many obstacles were in the way since the robot has last seen the goal or looked around for it
 */
public record Memory(
        Target target,
        Duration frameLimit,
        Duration settle,
        List<OdometryPose> stations,
        List<OdometryPose> obstacles,
        int side,
        int inARow) {
    /** A goal that was not seen for so many times as long as a frame may take is lost: after 0.6 s, or 50 mm. */
    private static final int LOST_FRAMES = 2;

    /** At the beginning. */
    public Memory(Target target, Duration frameLimit, Duration settle) {
        this(target, frameLimit, settle, List.of(), List.of(), 0, 0);
    }

    Memory withStation(OdometryPose place) {
        return new Memory(target, frameLimit, settle, and(stations, place), obstacles, side, 0);
    }

    /** Something stands there that is not in the way now. */
    Memory withObstacle(OdometryPose place) {
        return new Memory(target, frameLimit, settle, stations, and(obstacles, place), side, inARow);
    }

    /** Something is in the way there, and the robot goes round it to this side. */
    Memory withDetour(OdometryPose place, int newSide) {
        return new Memory(target, frameLimit, settle, stations, and(obstacles, place), newSide, inARow + 1);
    }

    /** Since when the goal must have been seen to be in sight now. */
    long seenSince(Situation now) {
        return now.nanos() - LOST_FRAMES * frameLimit.toNanos();
    }

    private static List<OdometryPose> and(List<OdometryPose> places, OdometryPose more) {
        return Stream.concat(places.stream(), Stream.of(more)).toList();
    }
}
