package org.evoloop.roomba;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.time.Duration;
import javax.imageio.ImageIO;
import org.evoloop.page.Picture;
import org.evoloop.roomba.camera.CameraSource;
import org.evoloop.roomba.camera.HttpCamera;
import org.evoloop.roomba.camera.Scene;
import org.evoloop.roomba.camera.Sighting;
import org.evoloop.roomba.camera.live.CameraSettings;
import org.evoloop.roomba.camera.vision.OpenCv;
import org.evoloop.roomba.move.StartPointSensor;
import org.evoloop.time.Clock;
import org.evoloop.time.ManualClock;
import org.evoloop.time.SystemClock;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** What viewers see of a camera that Move uses, from before its first picture until long after its last. */
@Timeout(60)
class EyesTest {
    private static final Duration LIMIT = Duration.ofSeconds(30);

    private final ManualClock viewers = new ManualClock();

    private Eyes eyes(String url) {
        // On a busy machine a frame may come late.
        CameraSettings settings = CameraSettings.of(CameraSource.parse(url)).withStaleAfter(Duration.ofSeconds(30));
        return new Eyes(OpenCv.vision(), settings, 1, viewers);
    }

    @Test
    void thePictureIsLiveWhileMoveRunsAndStaysWithItsAge() throws IOException {
        try (HttpCamera camera = new HttpCamera();
                Clock clock = new SystemClock()) {
            camera.repeat(Scene.jpeg(Scene.of(new Sighting(800, 0.1), 1)));
            Eyes eyes = eyes(camera.url());
            Picture picture = eyes.picture();
            assertThat(picture.isPrivate()).isTrue();
            assertThat(picture.view().get().content()).isEmpty();
            assertThat(picture.view().get().note())
                    .startsWith("No picture yet.")
                    .contains("Move");
            assertThat(camera.connections()).as("not opened for viewers").isZero();

            StartPointSensor sensor = eyes.apply(clock);
            try (sensor) {
                await().atMost(LIMIT).until(() -> picture.view().get().content().length > 0);
                Picture.View live = picture.view().get();
                assertThat(live.note()).isEqualTo("Taken 0.0 s ago.");
                assertThat(ImageIO.read(new ByteArrayInputStream(live.content()))
                                .getWidth())
                        .isEqualTo(640);
            }
            viewers.advance(Duration.ofSeconds(90));
            Picture.View last = picture.view().get();
            assertThat(last.content()).isNotEmpty();
            assertThat(last.note()).isEqualTo("Taken 1 min ago. The next picture is taken when Move drives the robot.");
            viewers.advance(Duration.ofHours(2));
            assertThat(picture.view().get().note()).startsWith("Taken 2 h 1 min ago.");
        }
    }

    @Test
    void aCameraThatCannotBeOpenedIsReportedWithoutItsPassword() {
        try (Clock clock = new SystemClock()) {
            Eyes eyes = eyes("http://me:secret@127.0.0.1:1/stream");
            try (StartPointSensor sensor = eyes.apply(clock)) {
                await().atMost(LIMIT)
                        .until(() -> eyes.picture()
                                .view()
                                .get()
                                .note()
                                .startsWith("No picture yet: camera http://***@127.0.0.1:1/"));
                await().atMost(LIMIT)
                        .until(() -> !sensor.look(null, 0).health().reason().endsWith("is being opened"));
                assertThat(eyes.picture().view().get().note())
                        .doesNotContain("secret")
                        .endsWith(".");
                assertThat(eyes.picture().view().get().content()).isEmpty();
            }
        }
    }
}
