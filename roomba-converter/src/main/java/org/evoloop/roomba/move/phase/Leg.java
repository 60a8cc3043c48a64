package org.evoloop.roomba.move.phase;

import org.evoloop.roomba.session.OdometryPose;

/**
 * Drives straight, slowly enough to touch an obstacle safely.
 *
 * @param lengthMm negative for backwards, where the robot has no bumper: only as far as it came from there
 * @param alert whether it ends when the goal comes into sight; false in a detour, or the robot would turn back at once
 */
record Leg(Memory memory, double lengthMm, boolean alert, OdometryPose from, Phase then) implements Phase {

    static Leg of(Memory memory, double lengthMm, Phase then) {
        return new Leg(memory, lengthMm, false, OdometryPose.ORIGIN, then);
    }

    /** The same leg, but it ends when the goal comes into sight. */
    Leg alertly() {
        return new Leg(memory, lengthMm, true, from, then);
    }

    @Override
    public Phase begun(Situation now) {
        return new Leg(memory, lengthMm, alert, now.pose(), then);
    }

    @Override
    public String describe() {
        return "driving around";
    }

    @Override
    public boolean leadsForward() {
        return lengthMm > 0;
    }

    @Override
    public Step next(Situation now) {
        if (alert && now.sight().goalSince(memory.seenSince(now)).isPresent()) {
            return Phase.standing(Look.around(memory, now));
        }
        double left = Math.abs(lengthMm) - now.distanceTo(from);
        if (left <= 0) {
            return Phase.standing(then.begun(now));
        }
        return new Step(this, Maneuver.straight(Math.copySign(left, lengthMm)));
    }
}
