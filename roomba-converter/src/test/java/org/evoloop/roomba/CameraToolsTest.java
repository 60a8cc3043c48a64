package org.evoloop.roomba;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.evoloop.roomba.camera.Scene;
import org.evoloop.roomba.camera.Sighting;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The camera's commands, in processes of their own, with and without OpenCV. */
@Timeout(180)
class CameraToolsTest {
    @TempDir
    Path folder;

    @ParameterizedTest
    @CsvSource({"camera /dev/video0", "calibrate --images . --out c.txt", "marker --dictionary 36h11 --out m.pdf"})
    void withoutOpenCvWhatNeedsItSaysWhatToInstall(String arguments) throws Exception {
        String[] words =
                arguments.replace("--images .", "--images " + pictures()).split(" ");

        Program.Result result = Program.runWithoutOpenCv(folder, words);

        assertThat(result.err())
                .isEqualTo("error: the camera needs OpenCV, and there is no opencv-*.jar in "
                        + folder.resolve("no-opencv") + " with its libopencv_java*.so in /usr/lib/jni; "
                        + "run: sudo apt-get install --no-install-recommends libopencv-java\n");
        assertThat(result.out()).isEmpty();
        assertThat(result.status()).isEqualTo(2);
    }

    private Path pictures() throws IOException {
        Path pictures = Files.createDirectories(folder.resolve("pictures"));
        Scene.write(pictures, "%d.png", Scene.empty(1));
        return pictures;
    }

    @Test
    void withoutOpenCvTheUsualMarkerIsPrinted() throws Exception {
        Path file = folder.resolve("marker.pdf");
        Program.Result result = Program.runWithoutOpenCv(folder, "marker", "--out", file.toString());

        assertThat(result.err()).isEmpty();
        assertThat(result.status()).isZero();
        assertThat(result.out())
                .isEqualTo(file + ": ArUco 4x4_50, id 0, side 150.0 mm; print at 100 %, mount upright at the camera's "
                        + "height\n");
        assertThat(file).exists();
    }

    @Test
    void theCameraCommandPrintsWhereTheMarkerIs() throws Exception {
        Scene.write(folder, "%02d.png", Scene.of(new Sighting(1000, 0.2), 1), Scene.of(new Sighting(1000, 0.2), 2));

        Program.Result result =
                Program.run(folder, "camera", folder.resolve("%02d.png").toString());

        assertThat(result.out())
                .contains("recording " + folder.resolve("%02d.png") + " is at its end")
                .containsPattern(
                        "marker at (99|100|101)\\d mm, \\+11\\.[45] degrees\n2 frames, the marker in 2 of them");
        assertThat(result.status()).isZero();
    }

    @Test
    void aCameraThatShowsNothingIsStatusOne() throws Exception {
        Program.Result result = Program.run(folder, "camera", "--seconds", "1", "/dev/video98");

        assertThat(result.out())
                .contains("gone: camera /dev/video98 does not exist; plug the camera in, or see ls /dev/v4l/by-id");
        assertThat(result.status()).isEqualTo(1);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "camera rtsp://x/ | camera rtsp://x/: rtsp is not supported; give a URL that begins with http:// or "
                        + "https:// and answers with Motion JPEG",
                "camera 0 --marker-id 50 | marker id 50 is not in 4x4_50; allowed is 0 to 49",
                "camera 0 --marker-side 1 | the marker's side is 1.0 mm, allowed is 10 to 2000",
                "camera 0 --field-of-view 200 | the camera's field of view is 200.0 degrees, allowed is 20 to 150",
                "camera 0 --camera-size big | --camera-size is big; write width x height, such as 640x480",
                "camera 0 --calibration c --field-of-view 60 | --calibration and --field-of-view say the same thing; "
                        + "give one of them",
                "camera 0 --calibration /no.txt | /no.txt: does not exist; correct the path",
                "camera 0 --record film.mp4 | film.mp4: cannot be written as a recording; its name must end with .avi, "
                        + "in a folder that may be written to",
                "camera 0 --seconds 0 | --seconds is 0, allowed is 1 to 86400",
                "marker --out marker.txt | --out marker.txt: is neither a .pdf nor a .png file; name it marker.pdf",
                "marker --out /no/m.pdf | --out /no/m.pdf: there is no such folder; correct the path",
                "calibrate --images /no --out c | --images /no: no picture has such a name; name a folder with .jpg or "
                        + ".png files, or a pattern such as 'pictures/*.jpg'",
                "calibrate --images /no/* --out c | --images /no/*: there is no such folder; correct the path",
                "calibrate --images / --board 9 --out c | --board is 9; write inner corners as columns x rows, 3x3 or "
                        + "more, such as 9x6 for a board of 10x7 squares",
            })
    void mistakesAreReportedOnceAndClearly(String arguments, String message) throws Exception {
        Program.Result result = Program.run(folder, arguments.split(" "));
        assertThat(result.err()).isEqualTo("error: " + message + "\n");
        assertThat(result.out()).isEmpty();
        assertThat(result.status()).isEqualTo(2);
    }
}
