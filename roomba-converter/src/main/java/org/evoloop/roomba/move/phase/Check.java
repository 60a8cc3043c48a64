package org.evoloop.roomba.move.phase;

import java.util.Optional;
import org.evoloop.roomba.session.OdometryPose;

/** Stands still, looks, and checks whether the robot has arrived; corrects position or heading if not. */
record Check(Memory memory, Calm calm) implements Phase {
    /** The robot has arrived when it faces the marker within 3 degrees; the rest is margin for the camera's error. */
    private static final double FACING_RAD = Math.toRadians(1.5);

    static Check begin(Memory memory, Situation now) {
        return new Check(memory, Calm.after(memory, now));
    }

    @Override
    public Phase begun(Situation now) {
        return begin(memory, now);
    }

    @Override
    public String describe() {
        return "checking the place";
    }

    @Override
    public boolean leadsForward() {
        return false;
    }

    @Override
    public Step next(Situation now) {
        Calm counted = calm.with(now.sight());
        Optional<OdometryPose> seen = now.sight().goalSince(calm.fromNanos());
        if (seen.isPresent() && counted.looks() >= Sight.BELIEVED_LOOKS) {
            return judge(now, seen.get());
        }
        return Phase.standing(
                counted.isUnsuccessful(now.sight()) ? Look.around(memory, now) : new Check(memory, counted));
    }

    private Step judge(Situation now, OdometryPose goal) {
        double bearingRad = now.bearingTo(goal);
        double remainingMm = now.distanceTo(goal) - memory.target().distanceMm();
        if (memory.target().facing() && Math.abs(bearingRad) > FACING_RAD) {
            return Phase.standing(Turn.exactly(memory, now.pose().headingRad() + bearingRad, this));
        }
        if (remainingMm > memory.target().toleranceMm()) {
            return Phase.standing(new Approach(memory));
        }
        if (remainingMm < -memory.target().toleranceMm()) {
            return Phase.standing(Leg.of(memory, remainingMm, this).begun(now));
        }
        return new Step(this, new Maneuver.Arrive());
    }
}
