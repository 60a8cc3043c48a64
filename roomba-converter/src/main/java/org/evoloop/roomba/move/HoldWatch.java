package org.evoloop.roomba.move;

import java.util.Optional;
import org.evoloop.roomba.move.phase.Ending;
import org.evoloop.roomba.session.Telemetry;

/**
 * Checks that the robot obeys. At a cliff it leaves Safe mode and stops (specification, "Safe Mode"); the session
 * regains control within a second or two, and Move continues. If the robot was lifted, its position is unknown, and
 * Move ends.
 *
 * <p>Threading: not thread-safe.
 */
final class HoldWatch {
    /** How long the session may take to regain control. */
    static final long PATIENCE_NANOS = 5_000_000_000L;

    /** How long the robot may take to obey at first: it may have to be woken, or leave its dock. */
    static final long READY_PATIENCE_NANOS = 20_000_000_000L;

    private boolean held;
    private boolean slipped;
    private long slippedNanos;

    /** Processes the next frame; returns why the robot must no longer be driven, or {@link Ending#NONE}. */
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
