package org.evoloop.roomba.camera;

import java.util.Optional;

/**
 * What a camera has seen last.
 *
 * @param frame counts the frames that were looked at, from 1; 0 before the first
 * @param takenNanos when the frame came, on the monotonic clock; meaningless before the first
 * @param health of the camera now, not when the frame came
 * @param sighting the marker, if this frame shows it
 * @since 0.1
 */
public record Look(long frame, long takenNanos, CameraHealth health, Optional<Sighting> sighting) {}
