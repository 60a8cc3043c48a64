package org.evoloop.roomba.move.phase;

/**
 * Counts the looks taken while the robot is at rest. Pictures taken at rest are sharp and give correct places.
 *
 * <p>Threading: immutable.
 *
 * @param fromNanos only looks taken after this moment count
 * @param frame the last frame that was counted
 * @param looks how many were counted
 */
record Calm(long fromNanos, long frame, int looks) {
    /** Enough looks to believe a place if each of them shows it. */
    private static final int FEWEST = Sight.BELIEVED_LOOKS;

    /** The most looks to wait for when some show the marker: enough for three in a row. */
    private static final int MOST = 9;

    /** Starts counting once the robot has settled; the stop command is sent now. */
    static Calm after(Memory memory, Situation now) {
        return new Calm(now.nanos() + memory.settle().toNanos(), now.sight().frame(), 0);
    }

    /** Counts the newest look. */
    Calm with(Sight sight) {
        boolean counts = sight.frame() != frame && sight.takenNanos() - fromNanos >= 0;
        return counts ? new Calm(fromNanos, sight.frame(), looks + 1) : this;
    }

    /** Whether the robot has looked long enough and the marker is not visible from here. */
    boolean isUnsuccessful(Sight sight) {
        return looks >= (sight.promising() ? MOST : FEWEST);
    }
}
