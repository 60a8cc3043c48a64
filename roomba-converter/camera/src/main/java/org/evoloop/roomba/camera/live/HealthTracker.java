package org.evoloop.roomba.camera.live;

import java.time.Duration;
import java.util.Locale;
import org.evoloop.roomba.camera.CameraHealth;
import org.evoloop.roomba.camera.CameraHealth.Condition;

/**
 * Derives a camera's condition from what has happened to it and how long ago.
 *
 * <p>Threading: thread-safe.
 */
final class HealthTracker {
    private final String camera;
    private final long staleNanos;

    private CameraHealth now;
    private long lastFrameNanos;
    private int damagedSince;

    HealthTracker(String camera, Duration staleAfter) {
        this.camera = camera;
        staleNanos = staleAfter.toNanos();
        now = new CameraHealth(Condition.OPENING, camera + " is being opened");
    }

    /** The source is being opened. */
    synchronized void opening() {
        damagedSince = 0;
        if (now.state() == Condition.GONE) {
            now = new CameraHealth(Condition.OPENING, "trying again: " + now.reason());
        }
    }

    /** A frame that arrived at {@code takenNanos} has been processed. */
    synchronized void seeing(long takenNanos) {
        if (now.state() != Condition.CLOSED) {
            now = CameraHealth.SEEING;
            lastFrameNanos = takenNanos;
            damagedSince = 0;
        }
    }

    synchronized void damaged() {
        damagedSince++;
    }

    /** Frames arrive, but processing them fails. */
    synchronized void blind(String reason) {
        if (now.state() != Condition.CLOSED) {
            now = new CameraHealth(Condition.STALLED, reason);
        }
    }

    synchronized void gone(String reason) {
        if (now.state() != Condition.CLOSED) {
            now = new CameraHealth(Condition.GONE, reason);
        }
    }

    synchronized void closed() {
        now = new CameraHealth(Condition.CLOSED, camera + " is closed");
    }

    synchronized CameraHealth at(long nanos) {
        long ageNanos = nanos - lastFrameNanos;
        if (now.state() != Condition.SEEING || ageNanos <= staleNanos) {
            return now;
        }
        String age = String.format(Locale.ROOT, "%.1f s", ageNanos / 1e9);
        return new CameraHealth(
                Condition.STALLED,
                damagedSince == 0
                        ? camera + " has sent no frame for " + age + "; check its cable and power"
                        : camera + " has sent " + damagedSince + " damaged frames and no good one for " + age
                                + "; check its cable, or ask it for smaller frames");
    }
}
