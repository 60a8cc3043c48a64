package org.evoloop.roomba.move.phase;

/** Turns on the spot; a round robot cannot hit anything by turning. */
record Turn(Memory memory, double headingRad, double exactRad, Phase then) implements Phase {
    /** Twice the angle by which the robot turns on after the stop command. */
    private static final double EXACTLY_RAD = Math.toRadians(0.7);

    /** Precise enough to look or drive in a direction, and reached soon. */
    private static final double ROUGHLY_RAD = Math.toRadians(4);

    static Turn exactly(Memory memory, double headingRad, Phase then) {
        return new Turn(memory, headingRad, EXACTLY_RAD, then);
    }

    static Turn roughly(Memory memory, double headingRad, Phase then) {
        return new Turn(memory, headingRad, ROUGHLY_RAD, then);
    }

    @Override
    public Phase begun(Situation now) {
        return this;
    }

    @Override
    public String describe() {
        return "turning";
    }

    @Override
    public boolean leadsForward() {
        return false;
    }

    @Override
    public Step next(Situation now) {
        double left = Math.IEEEremainder(headingRad - now.pose().headingRad(), 2 * Math.PI);
        return Math.abs(left) <= exactRad ? Phase.standing(then.begun(now)) : new Step(this, Maneuver.turn(left));
    }
}
