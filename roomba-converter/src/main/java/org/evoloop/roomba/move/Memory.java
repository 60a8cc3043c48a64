package org.evoloop.roomba.move;

import java.time.Duration;
import java.util.List;
import java.util.stream.Stream;
import org.evoloop.roomba.session.Pose;

/**
 * What Move remembers from phase to phase.
 *
 * <p>Threading: immutable.
 *
 * @param target where the robot has arrived
 * @param settle so long after it was told to stop, the robot stands
 * @param avoided places that are not worth going to: something is there, or the robot looked around there in vain
 * @param detours how many obstacles were in the way
 * @param side to which the last one was gone round: 1 left, -1 right, 0 if there was none
 */
record Memory(StartPointSensor.Target target, Duration settle, List<Pose> avoided, int detours, int side) {
    private static final int PARTS = 4;

    Memory(StartPointSensor.Target target, Duration settle) {
        this(target, settle, List.of(), 0, 0);
    }

    Memory avoiding(Pose place) {
        List<Pose> more = Stream.concat(avoided.stream(), Stream.of(place)).toList();
        return new Memory(target, settle, more, detours, side);
    }

    Memory withDetour(int newSide) {
        return new Memory(target, settle, avoided, detours + 1, newSide);
    }

    /** How far the farther half of a leg stays from all that is avoided. */
    double clearanceMm(Pose from, double headingRad, double lengthMm) {
        double least = Double.POSITIVE_INFINITY;
        for (int part = PARTS / 2; part <= PARTS; part++) {
            Pose there = from.beyond(lengthMm * part / PARTS, headingRad - from.headingRad());
            for (Pose place : avoided) {
                least = Math.min(least, there.distanceTo(place.xMm(), place.yMm()));
            }
        }
        return least;
    }
}
