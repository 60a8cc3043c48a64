package org.evoloop.roomba.move.phase;

/**
 * Counts the looks that were taken while the robot stands. A still picture is sharp, and shows things where they are.
 *
 * <p>Threading: immutable.
 *
 * @param fromNanos looks from this moment on count
 * @param frame the last one that was counted
 * @param looks how many there were
 */
record Calm(long fromNanos, long frame, int looks) {
    /** So many looks, and a place is believed if each of them shows it. */
    private static final int FEWEST = Sight.BELIEVED_LOOKS;

    /** So many where some of them show something: enough for three in a row. */
    private static final int MOST = 9;

    /** The robot is told to stop now. */
    static Calm after(Memory memory, Situation now) {
        return new Calm(now.nanos() + memory.settle().toNanos(), now.sight().frame(), 0);
    }

    /** Counts the newest look. */
    Calm with(Sight sight) {
        boolean counts = sight.frame() != frame && sight.takenNanos() - fromNanos >= 0;
        return counts ? new Calm(fromNanos, sight.frame(), looks + 1) : this;
    }

    /** Whether the marker would have been seen here. */
    boolean isInVain(Sight sight) {
        return looks >= (sight.promising() ? MOST : FEWEST);
    }
}
