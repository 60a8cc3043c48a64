package org.evoloop.roomba.move.phase;

import java.util.Optional;
import org.evoloop.roomba.session.OdometryPose;

/** Drives towards the goal in sight. */
record Approach(Memory memory) implements Phase {
    /** If the goal is further to the side than this, the robot turns on the spot first. */
    private static final double TURN_RAD = Math.toRadians(20);

    @Override
    public Phase begun(Situation now) {
        return this;
    }

    @Override
    public String describe() {
        return "driving to the starting point";
    }

    @Override
    public boolean leadsForward() {
        return true;
    }

    @Override
    public Step next(Situation now) {
        Optional<OdometryPose> seen = now.sight().goalSince(memory.seenSince(now));
        if (seen.isEmpty()) {
            return Phase.standing(Look.around(memory, now));
        }
        OdometryPose goal = seen.get();
        double remainingMm = now.distanceTo(goal) - memory.target().distanceMm();
        double bearingRad = now.bearingTo(goal);
        if (remainingMm <= memory.target().toleranceMm() / 2) {
            return Phase.standing(Check.begin(memory, now));
        }
        if (Math.abs(bearingRad) > TURN_RAD) {
            return Phase.standing(Turn.exactly(memory, now.pose().headingRad() + bearingRad, this));
        }
        return new Step(this, Maneuver.towards(remainingMm, bearingRad));
    }
}
