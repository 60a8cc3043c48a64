package org.evoloop.roomba.move;

import java.util.Optional;
import org.evoloop.roomba.move.phase.Ending;
import org.evoloop.roomba.session.Telemetry;

/**
 * Whether the robot obeys. At a cliff it leaves Safe mode and stops (specification, "Safe Mode"), and the session takes
 * it back within a second or two; then Move goes on. A robot that was lifted is somewhere else now, and Move ends.
 *
 * <p>Threading: not thread-safe.
 */
final class HoldWatch {
    /** So long the session has to take control back. */
    static final long PATIENCE_NANOS = 5_000_000_000L;

    /** So long it may take until the robot obeys at first: it may have to be woken, or leave its dock. */
    static final long READY_PATIENCE_NANOS = 20_000_000_000L;

    private boolean held;
    private boolean slipped;
    private long slippedNanos;

    /** Takes the next frame; returns why the robot must not be driven on, if that is so. */
    Ending update(Telemetry telemetry, long nanos) {
        if (telemetry.values().anyWheelDrop()) {
            return Ending.byPerson(
                    "a wheel hangs in the air: the robot was lifted, or has driven over an edge", Optional.empty());
        }
        if (telemetry.isUnderControl()) {
            held = true;
            slipped = false;
            return Ending.NONE;
        }
        if (!slipped) {
            slipped = true;
            slippedNanos = nanos;
        }
        long patience = held ? PATIENCE_NANOS : READY_PATIENCE_NANOS;
        return nanos - slippedNanos > patience ? Ending.because("the robot does not obey any more") : Ending.NONE;
    }
}
