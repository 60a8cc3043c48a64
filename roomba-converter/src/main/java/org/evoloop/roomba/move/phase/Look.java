package org.evoloop.roomba.move.phase;

/**
 * Looks around on the spot, standing still for each look: first towards where the goal was last seen, or ahead, then
 * right and left of that, until all directions are covered.
 *
 * @param aheadRad the heading of the first look
 * @param direction the number of looks already taken
 */
record Look(Memory memory, double aheadRad, int direction, Calm calm) implements Phase {
    /** From one direction to the next: a camera with a view of 60 degrees covers everything, and most of it twice. */
    static final double STEP_RAD = Math.toRadians(40);

    static final int DIRECTIONS = 9;

    /** About how far from the robot's centre the light bumper detects something. */
    private static final double NEAR_MM = 400;

    /** Starts looking around from the robot's pose at that time. */
    record Around(Memory memory) implements Phase {
        @Override
        public Phase begun(Situation now) {
            return around(memory, now);
        }

        @Override
        public String describe() {
            return "looking around";
        }

        @Override
        public boolean leadsForward() {
            return false;
        }

        @Override
        public Step next(Situation now) {
            return Phase.standing(begun(now));
        }
    }

    /** Starts looking around. */
    static Phase around(Memory memory, Situation now) {
        double ahead = now.sight()
                .goal()
                .map(goal -> now.pose().headingRad() + now.bearingTo(goal))
                .orElse(now.pose().headingRad());
        return new Look(memory, ahead, 0, Calm.after(memory, now)).turned();
    }

    @Override
    public Phase begun(Situation now) {
        return new Look(memory, aheadRad, direction, Calm.after(memory, now));
    }

    private Phase turned() {
        return Turn.roughly(memory, heading(direction), this);
    }

    private double heading(int which) {
        // Offsets in steps: 0, -1, 1, 2, 3 and so on.
        return aheadRad + STEP_RAD * (which == 0 ? 0 : which == 1 ? -1 : which - 1);
    }

    @Override
    public String describe() {
        return "looking around";
    }

    @Override
    public boolean leadsForward() {
        return false;
    }

    @Override
    public Step next(Situation now) {
        Calm counted = calm.with(now.sight());
        if (now.sight().goalSince(calm.fromNanos()).isPresent()) {
            return Phase.standing(new Approach(memory));
        }
        if (!counted.isUnsuccessful(now.sight())) {
            return Phase.standing(new Look(memory, aheadRad, direction, counted));
        }
        if (now.near()) {
            Memory updated = memory.withObstacle(now.pose().beyond(NEAR_MM, 0));
            return new Look(updated, aheadRad, direction, counted).onwards(now);
        }
        return onwards(now);
    }

    private Step onwards(Situation now) {
        return Phase.standing(
                direction + 1 < DIRECTIONS
                        ? new Look(memory, aheadRad, direction + 1, calm).turned()
                        : Wandering.on(
                                memory.withStation(now.pose()),
                                now.pose(),
                                now.sight().goal()));
    }
}
