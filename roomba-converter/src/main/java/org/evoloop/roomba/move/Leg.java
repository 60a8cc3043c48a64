package org.evoloop.roomba.move;

import org.evoloop.roomba.session.Pose;

/**
 * Drives straight on, so slowly that whatever is in the way may be touched.
 *
 * @param lengthMm negative is backwards, where nothing is felt: only as far as the robot came from there
 */
record Leg(Memory memory, double lengthMm, Pose from, Phase then) implements Phase {

    static Leg of(Memory memory, double lengthMm, Phase then) {
        return new Leg(memory, lengthMm, Pose.ORIGIN, then);
    }

    @Override
    public Phase begun(Situation now) {
        return new Leg(memory, lengthMm, now.pose(), then);
    }

    @Override
    public boolean leadsForward() {
        return lengthMm > 0;
    }

    @Override
    public Step next(Situation now) {
        double left = Math.abs(lengthMm) - now.distanceTo(from);
        if (left <= 0) {
            return Phase.standing(then.begun(now));
        }
        return new Step(this, Maneuver.straight(Math.copySign(left, lengthMm)));
    }
}
