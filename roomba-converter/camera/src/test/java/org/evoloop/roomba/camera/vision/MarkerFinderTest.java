package org.evoloop.roomba.camera.vision;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Optional;
import org.evoloop.roomba.camera.CameraException;
import org.evoloop.roomba.camera.CameraModel;
import org.evoloop.roomba.camera.MarkerDictionary;
import org.evoloop.roomba.camera.MarkerSpec;
import org.evoloop.roomba.camera.Scene;
import org.evoloop.roomba.camera.Sighting;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class MarkerFinderTest {
    private final MarkerFinder finder = OpenCv.vision().finder(MarkerSpec.DEFAULT, CameraModel.DEFAULT);

    @AfterEach
    void close() {
        finder.close();
    }

    private Optional<Sighting> find(BufferedImage picture) {
        return finder.find(Scene.pixels(picture), Scene.WIDTH, Scene.HEIGHT);
    }

    @ParameterizedTest
    @CsvSource({"400, 0", "500, 15", "1000, -20", "1500, 10", "2000, -5", "2500, 24", "3000, 0"})
    void measuresDistanceAndBearing(double distanceMm, double bearingDegrees) {
        Sighting truth = new Sighting(distanceMm, Math.toRadians(bearingDegrees));

        Optional<Sighting> seen = find(Scene.of(truth, 1));

        assertThat(seen).isPresent();
        assertThat(seen.get().distanceMm()).isCloseTo(distanceMm, within(0.04 * distanceMm));
        assertThat(Math.toDegrees(seen.get().bearingRad())).isCloseTo(bearingDegrees, within(0.2));
    }

    @Test
    void seesNothingOnAnEmptyWall() {
        for (int seed = 0; seed < 8; seed++) {
            assertThat(find(Scene.empty(seed))).as("seed %d", seed).isEmpty();
        }
    }

    @Test
    void passesOverMarkersOfOtherIds() {
        MarkerSpec other = new MarkerSpec(MarkerDictionary.ARUCO_4X4_50, 7, 150);
        byte[] picture = Scene.pixels(Scene.of(new Sighting(800, 0), 1));
        try (MarkerFinder otherFinder = OpenCv.vision().finder(other, CameraModel.DEFAULT)) {
            assertThat(otherFinder.find(picture, Scene.WIDTH, Scene.HEIGHT)).isEmpty();
        }
    }

    @Test
    void takesGrayPicturesToo() {
        byte[] colored = Scene.pixels(Scene.of(new Sighting(800, 0.1), 1));
        byte[] gray = new byte[colored.length / 3];
        for (int i = 0; i < gray.length; i++) {
            gray[i] = colored[3 * i];
        }

        assertThat(finder.find(gray, Scene.WIDTH, Scene.HEIGHT))
                .hasValueSatisfying(
                        sighting -> assertThat(sighting.distanceMm()).isCloseTo(800, within(20.0)));
    }

    @Test
    void scalesDistanceWithTheMarkersSide() {
        MarkerSpec small = new MarkerSpec(MarkerDictionary.ARUCO_4X4_50, 0, 75);
        byte[] picture = Scene.pixels(Scene.of(new Sighting(1000, 0), 1));
        try (MarkerFinder smallFinder = OpenCv.vision().finder(small, CameraModel.DEFAULT)) {
            assertThat(smallFinder
                            .find(picture, Scene.WIDTH, Scene.HEIGHT)
                            .orElseThrow()
                            .distanceMm())
                    .isCloseTo(
                            find(Scene.of(new Sighting(1000, 0), 1))
                                            .orElseThrow()
                                            .distanceMm()
                                    / 2,
                            within(0.1));
        }
    }

    @Test
    void refusesPixelsThatAreNoPicture() {
        assertThatThrownBy(() -> finder.find(new byte[100], 640, 480))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("100 bytes are neither a gray nor a color picture of 640x480");
    }

    @Test
    void refusesFramesOfAnotherShapeThanTheCalibration() {
        CameraModel measured = new CameraModel.Calibrated(
                640, 360, new CameraModel.Intrinsics(550, 550, 320, 180, List.of(0.0, 0.0, 0.0, 0.0, 0.0)));
        byte[] picture = Scene.pixels(Scene.of(new Sighting(800, 0), 1));
        try (MarkerFinder calibrated = OpenCv.vision().finder(MarkerSpec.DEFAULT, measured)) {
            assertThatThrownBy(() -> calibrated.find(picture, Scene.WIDTH, Scene.HEIGHT))
                    .isInstanceOf(CameraException.class)
                    .hasMessage("the calibration is for frames of 640x360, the camera sends 640x480; calibrate with "
                            + "frames of that shape");
        }
    }
}
