package org.evoloop.roomba.camera;

import java.util.Optional;

/**
 * The last frame of a camera and its marker.
 *
 * @param frame the number of processed frames, from 1; 0 before the first
 * @param takenNanos when the frame arrived, on the monotonic clock; meaningless before the first
 * @param health the camera's current health, not its health when the frame arrived
 * @param sighting the marker, if this frame shows it
 * @since 0.1
 */
public record Look(long frame, long takenNanos, CameraHealth health, Optional<Sighting> sighting) {}
