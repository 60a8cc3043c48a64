package org.evoloop.roomba.camera.vision;

import java.nio.file.Path;
import java.util.List;
import org.evoloop.roomba.camera.CameraModel;

/**
 * The result of a calibration.
 *
 * @param errorPx the root mean square distance of corners from their positions by the model, in pixels; below 1 is good
 * @param used the pictures used
 * @param withoutBoard pictures in which no complete board was found
 * @since 0.1
 */
public record Calibration(CameraModel.Calibrated model, double errorPx, List<Path> used, List<Path> withoutBoard) {
    /** With fewer pictures of the board, focal length and distortion cannot be separated. */
    public static final int FEWEST_PICTURES = 3;

    public Calibration {
        used = List.copyOf(used);
        withoutBoard = List.copyOf(withoutBoard);
    }
}
