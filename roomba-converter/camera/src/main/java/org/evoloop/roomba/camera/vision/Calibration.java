package org.evoloop.roomba.camera.vision;

import java.nio.file.Path;
import java.util.List;
import org.evoloop.roomba.camera.CameraModel;

/**
 * What a calibration came to.
 *
 * @param errorPx root mean square of how far corners lie from where the model puts them, in pixels; good is below 1
 * @param used the pictures that it rests on
 * @param withoutBoard pictures in which no whole board was found
 * @since 0.1
 */
public record Calibration(CameraModel.Calibrated model, double errorPx, List<Path> used, List<Path> withoutBoard) {
    /** With fewer pictures of the board there is no telling focal length and distortion apart. */
    public static final int FEWEST_PICTURES = 3;

    public Calibration {
        used = List.copyOf(used);
        withoutBoard = List.copyOf(withoutBoard);
    }
}
