package org.evoloop.roomba.camera.vision;

import java.util.List;
import org.evoloop.roomba.camera.Sighting;

/**
 * A marker in a frame.
 *
 * @param corners clockwise from the marker's own upper left
 * @since 0.1
 */
public record Detection(int id, List<Corner> corners, Sighting sighting) {

    /** A point in the frame, in pixels from the upper left. */
    public record Corner(double x, double y) {}

    public Detection {
        corners = List.copyOf(corners);
    }
}
