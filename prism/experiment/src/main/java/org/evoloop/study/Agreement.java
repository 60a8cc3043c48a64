package org.evoloop.study;

/**
 * Whether the converter's record of the device is right, and since when.
 *
 * <p>Threading: for one thread at a time.
 */
final class Agreement {
    /** When it became wrong, right, wrong, and so on. */
    private final TimeLog turns = new TimeLog();

    /** @param atNanos not before the last time */
    void note(boolean right, long atNanos) {
        boolean wasRight = turns.size() % 2 == 0;
        if (right != wasRight) {
            turns.add(atNanos);
        }
    }

    /** When it was first wrong; negative while never. */
    long divergedNanos() {
        return turns.size() == 0 ? -1 : turns.at(1);
    }

    /** For how long it was wrong between these times, in nanoseconds. */
    long wrongNanos(long firstNanos, long lastNanos) {
        long wrong = 0;
        for (int turn = turns.until(firstNanos) / 2 * 2 + 1;
                turn <= turns.size() && turns.at(turn) < lastNanos;
                turn += 2) {
            long end = turn < turns.size() ? turns.at(turn + 1) : lastNanos;
            wrong += Math.min(end, lastNanos) - Math.max(turns.at(turn), firstNanos);
        }
        return wrong;
    }
}
