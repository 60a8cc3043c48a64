package org.evoloop.roomba.camera.vision;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.evoloop.roomba.camera.CameraException;
import org.evoloop.roomba.camera.CameraModel.Intrinsics;
import org.evoloop.roomba.camera.Scene;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class CalibrationTest {
    private static final Chessboard BOARD = new Chessboard(9, 6, 25);
    private static final double FOCAL = 600;
    private static final double CENTER_X = 310;
    private static final double CENTER_Y = 250;

    @TempDir
    Path folder;

    /** A board turned about the vertical and then the horizontal axis, 450 mm away. */
    private static BufferedImage board(double yaw, double pitch) {
        BufferedImage picture = new BufferedImage(640, 480, BufferedImage.TYPE_3BYTE_BGR);
        double[] right = {Math.cos(yaw), 0, -Math.sin(yaw)};
        double[] down = {Math.sin(pitch) * Math.sin(yaw), Math.cos(pitch), Math.sin(pitch) * Math.cos(yaw)};
        double[] normal = {
            right[1] * down[2] - right[2] * down[1],
            right[2] * down[0] - right[0] * down[2],
            right[0] * down[1] - right[1] * down[0]
        };
        for (int y = 0; y < 480; y++) {
            for (int x = 0; x < 640; x++) {
                double light = 0;
                for (int sample = 0; sample < 16; sample++) {
                    double[] ray = {
                        (x + (sample % 4 - 1.5) / 4 - CENTER_X) / FOCAL,
                        (y + (Math.floorDiv(sample, 4) - 1.5) / 4 - CENTER_Y) / FOCAL,
                        1
                    };
                    double reach = normal[2] * 450 / dot(normal, ray);
                    double[] from = {ray[0] * reach, ray[1] * reach, ray[2] * reach - 450};
                    light += brightness(dot(right, from), dot(down, from));
                }
                int gray = (int) (light / 16);
                picture.setRGB(x, y, gray << 16 | gray << 8 | gray);
            }
        }
        return picture;
    }

    private static double dot(double[] one, double[] other) {
        return one[0] * other[0] + one[1] * other[1] + one[2] * other[2];
    }

    private static double brightness(double x, double y) {
        int column = (int) Math.floor(x / 25 + 5);
        int row = (int) Math.floor(y / 25 + 3.5);
        return column < 0 || row < 0 || column > 9 || row > 6 || (column + row) % 2 == 0 ? 230 : 20;
    }

    private List<Path> write(BufferedImage... pictures) throws IOException {
        Scene.write(folder, "%d.png", pictures);
        List<Path> files = new ArrayList<>();
        for (int i = 0; i < pictures.length; i++) {
            files.add(folder.resolve(i + ".png"));
        }
        return files;
    }

    @Test
    void measuresTheCameraThatTookThePictures() throws IOException {
        List<Path> files = write(
                board(0.4, 0), board(-0.4, 0.2), board(0, 0.5), board(0.1, -0.5), Scene.empty(1), board(0.3, 0.35));

        Calibration calibration = OpenCv.vision().calibrate(files, BOARD);

        Intrinsics measured = calibration.model().intrinsics();
        assertThat(measured.focalX()).isCloseTo(FOCAL, within(6.0));
        assertThat(measured.focalY()).isCloseTo(FOCAL, within(6.0));
        assertThat(measured.centerX()).isCloseTo(CENTER_X, within(6.0));
        assertThat(measured.centerY()).isCloseTo(CENTER_Y, within(6.0));
        assertThat(calibration.errorPx()).isBetween(0.0, 0.2);
        assertThat(calibration.used()).hasSize(5);
        assertThat(calibration.withoutBoard()).containsExactly(folder.resolve("4.png"));
    }

    @Test
    void refusesTooFewBoards() throws IOException {
        List<Path> files = write(board(0.4, 0), board(-0.4, 0.2), Scene.empty(1));
        assertThatThrownBy(() -> OpenCv.vision().calibrate(files, BOARD))
                .isInstanceOf(CameraException.class)
                .hasMessage("only 2 pictures show the whole chessboard of 9x6 inner corners, and calibrating takes 3; "
                        + "without it: " + folder.resolve("2.png") + "; take more, in even light");
    }

    @Test
    void refusesPicturesOfDifferentSizes() throws IOException {
        List<Path> files = write(board(0.4, 0), new BufferedImage(320, 240, BufferedImage.TYPE_3BYTE_BGR));
        assertThatThrownBy(() -> OpenCv.vision().calibrate(files, BOARD))
                .isInstanceOf(CameraException.class)
                .hasMessage(folder.resolve("1.png")
                        + ": is 320x240, the pictures before are 640x480; use frames of one size");
    }
}
