package org.evoloop.roomba.move;

import org.evoloop.roomba.session.Telemetry;

/**
 * Whether the robot obeys. At a cliff it leaves Safe mode and stops (specification, "Safe Mode"), and the session takes it
 * back within a second or two; then Move goes on. A robot that was lifted is somewhere else now, and Move ends.
 *
 * <p>Threading: not thread-safe.
 */
final class HoldWatch {
    /** So long the session has to take control back. */
    static final long PATIENCE_NANOS = 5_000_000_000L;

    private boolean slipped;
    private long slippedNanos;

    /** Takes the next frame; returns why the robot will not obey again, empty while it does or may. */
    String update(Telemetry telemetry, long nanos) {
        if (telemetry.isUnderControl()) {
            slipped = false;
            return "";
        }
        if (!slipped) {
            slipped = true;
            slippedNanos = nanos;
        }
        if (telemetry.values().anyWheelDrop()) {
            return "a wheel hangs in the air: the robot was lifted, or has driven over an edge";
        }
        return nanos - slippedNanos > PATIENCE_NANOS ? "the robot does not obey any more" : "";
    }
}
