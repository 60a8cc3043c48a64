package org.evoloop.roomba.move.phase;

import org.evoloop.roomba.session.OdometryPose;

/**
 * Drives straight on, so slowly that whatever is in the way may be touched.
 *
 * @param lengthMm negative is backwards, where nothing is felt: only as far as the robot came from there
 * @param alert whether it ends when the goal comes into sight; a detour must not, for it would lead back at once
 */
record Leg(Memory memory, double lengthMm, boolean alert, OdometryPose from, Phase then) implements Phase {

    static Leg of(Memory memory, double lengthMm, Phase then) {
        return new Leg(memory, lengthMm, false, OdometryPose.ORIGIN, then);
    }

    /** The same, but it ends when the goal comes into sight. */
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
