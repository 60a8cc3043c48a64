package org.evoloop.roomba.camera;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.evoloop.roomba.camera.CameraModel.Calibrated;
import org.evoloop.roomba.camera.CameraModel.Intrinsics;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class CalibrationFileTest {
    private static final String GOOD = "width 640\nheight 480\nfocal 554.3 554.1\ncenter 319.6 240.2\n";

    @TempDir
    Path folder;

    private Path file(String text) throws IOException {
        return Files.writeString(folder.resolve("camera.txt"), text);
    }

    @Test
    void readsWhatItWrites() throws IOException {
        Calibrated model = new Calibrated(
                1280, 720, new Intrinsics(900.5, 901.25, 640.125, 359.5, List.of(0.1, -0.25, 0.001, 0.0, 0.05)));
        Path file = folder.resolve("written.txt");

        CalibrationFile.write(file, model, "from 12 pictures");

        assertThat(CalibrationFile.read(file)).isEqualTo(model);
        assertThat(file).content().startsWith("# from 12 pictures\n");
    }

    @Test
    void needsNoDistortionAndPassesOverComments() throws IOException {
        assertThat(CalibrationFile.read(file("# mine\n\n" + GOOD.replace("480", "480 # rows"))))
                .isEqualTo(new Calibrated(640, 480, new Intrinsics(554.3, 554.1, 319.6, 240.2, List.of())));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "width 640 | width 640 480 | line 1: width takes one number, there are 2",
                "focal 554.3 554.1 | focal 554.3 | line 3: focal takes 2 numbers, there are 1",
                "focal 554.3 554.1 | focal wide 554 | line 3: wide is not a number",
                "focal 554.3 554.1 | focal NaN 554 | line 3: NaN is not a number",
                "focal 554.3 554.1 | focal 0 554 | focal 0.0 is impossible; calibrate again",
                "center 319.6 240.2 | center 700 240 | center 700.0 is impossible; calibrate again",
                "width 640 | width 640.5 | width 640.5 is impossible; calibrate again",
                "height 480 | zoom 2 | line 2: zoom is unknown; allowed are width, height, focal, center and "
                        + "distortion",
                "height 480 | width 640 | line 2: width is there twice; remove one",
                "height 480 | # no height | has no height; write the file with: calibrate",
            })
    void namesTheLineThatIsWrong(String right, String wrong, String problem) throws IOException {
        Path file = file(GOOD.replace(right, wrong));
        assertThatThrownBy(() -> CalibrationFile.read(file))
                .isInstanceOf(CameraException.class)
                .hasMessage(file + ": " + problem);
    }

    @Test
    void refusesWhatIsNotText() throws IOException {
        Path binary = Files.write(folder.resolve("binary"), new byte[] {(byte) 0xff, (byte) 0xfe, 0});
        assertThatThrownBy(() -> CalibrationFile.read(binary))
                .isInstanceOf(CameraException.class)
                .hasMessage(binary + ": is not text; write it with: calibrate");
    }

    @Test
    void scalesToOtherSizesOfTheSameShapeOnly() throws IOException {
        Calibrated model = CalibrationFile.read(file(GOOD));
        Intrinsics half = model.forSize(320, 240);
        assertThat(half.focalX()).isCloseTo(277.15, within(1e-9));
        assertThat(half.centerX()).isCloseTo(159.55, within(1e-9));
        assertThatThrownBy(() -> model.forSize(640, 360)).isInstanceOf(CameraException.class);
    }
}
