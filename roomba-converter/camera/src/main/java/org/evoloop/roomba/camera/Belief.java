package org.evoloop.roomba.camera;

import java.util.Optional;

/**
 * Accepts a marker after several frames in a row have shown it in about the same place. A frame without it, or with it
 * elsewhere, restarts the count.
 *
 * <p>Threading: for one thread.
 *
 * @since 0.1
 */
public final class Belief {
    /** More than the fastest robot turns between two frames of a slow camera. */
    private static final double SAME_BEARING_RAD = Math.toRadians(25);

    private static final double SAME_DISTANCE = 0.35;

    private final int framesInARow;
    private int agreeing;
    private Optional<Sighting> previous = Optional.empty();

    /** @param framesInARow the number of frames required, from 1 */
    public Belief(int framesInARow) {
        this.framesInARow = framesInARow;
    }

    /** The accepted sighting after a frame that shows {@code seen}. */
    public Optional<Sighting> after(Optional<Sighting> seen) {
        if (seen.isEmpty()) {
            agreeing = 0;
        } else if (agreeing > 0 && previous.isPresent() && agree(previous.get(), seen.get())) {
            agreeing++;
        } else {
            agreeing = 1;
        }
        previous = seen;
        return agreeing >= framesInARow ? seen : Optional.empty();
    }

    private static boolean agree(Sighting one, Sighting other) {
        double farther = Math.max(one.distanceMm(), other.distanceMm());
        return Math.abs(one.bearingRad() - other.bearingRad()) <= SAME_BEARING_RAD
                && Math.abs(one.distanceMm() - other.distanceMm()) <= SAME_DISTANCE * farther;
    }
}
