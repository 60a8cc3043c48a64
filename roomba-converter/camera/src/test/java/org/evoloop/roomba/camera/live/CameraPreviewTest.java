package org.evoloop.roomba.camera.live;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.lang.reflect.Proxy;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.concurrent.atomic.AtomicInteger;
import javax.imageio.ImageIO;
import org.evoloop.roomba.camera.CameraModel;
import org.evoloop.roomba.camera.CameraSource;
import org.evoloop.roomba.camera.HttpCamera;
import org.evoloop.roomba.camera.MarkerSpec;
import org.evoloop.roomba.camera.Scene;
import org.evoloop.roomba.camera.Sighting;
import org.evoloop.roomba.camera.vision.Frame;
import org.evoloop.roomba.camera.vision.FrameReader;
import org.evoloop.roomba.camera.vision.FrameReader.Received;
import org.evoloop.roomba.camera.vision.FrameSize;
import org.evoloop.roomba.camera.vision.MarkerFinder;
import org.evoloop.roomba.camera.vision.OpenCv;
import org.evoloop.roomba.camera.vision.Vision;
import org.evoloop.time.Clock;
import org.evoloop.time.ManualClock;
import org.evoloop.time.SystemClock;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Pictures are made only while they are requested, at a limited rate, and remain when their camera is closed. */
class CameraPreviewTest {
    private static final Sighting AHEAD = new Sighting(800, 0.1);
    private static final Duration SHORT_OF_A_TURN = Duration.ofMillis(249);

    private final AtomicInteger encoded = new AtomicInteger();
    private final ManualClock clock = new ManualClock();
    private final CameraPreview preview = new CameraPreview(countingVision(), clock);
    private final Frame frame = OpenCv.vision().newFrame();

    @TempDir
    Path folder;

    /** OpenCV's vision, which counts the pictures that it encodes. */
    private Vision countingVision() {
        return (Vision) Proxy.newProxyInstance(
                Vision.class.getClassLoader(), new Class<?>[] {Vision.class}, (proxy, method, arguments) -> {
                    if (method.getName().equals("jpeg")) {
                        encoded.incrementAndGet();
                    }
                    return method.invoke(OpenCv.vision(), arguments);
                });
    }

    @BeforeEach
    void fill() throws IOException {
        read(Scene.of(AHEAD, 1));
    }

    @AfterEach
    void free() {
        frame.close();
    }

    private void read(BufferedImage picture) throws IOException {
        Path file = folder.resolve("0.png");
        ImageIO.write(picture, "png", file.toFile());
        try (FrameReader reader = OpenCv.vision().open(CameraSource.parse(file.toString()), FrameSize.DEFAULT)) {
            assertThat(reader.read(frame)).isEqualTo(Received.FRAME);
        }
        Files.delete(file);
    }

    private CameraPreview.Shot shot() {
        return preview.newest().orElseThrow();
    }

    private BufferedImage picture() throws IOException {
        return ImageIO.read(new ByteArrayInputStream(shot().jpeg()));
    }

    @Test
    void theMarkerCanBeFoundInThePicture() throws IOException {
        assertThat(preview.newest()).isEmpty();
        preview.offer(frame);

        assertThat(picture().getWidth()).isEqualTo(640);
        assertThat(picture().getHeight()).isEqualTo(480);
        Path file = folder.resolve("shown.jpg");
        Files.write(file, shot().jpeg());
        try (FrameReader reader = OpenCv.vision().open(CameraSource.parse(file.toString()), FrameSize.DEFAULT);
                Frame shown = OpenCv.vision().newFrame();
                MarkerFinder finder = OpenCv.vision().finder(MarkerSpec.DEFAULT, CameraModel.DEFAULT)) {
            assertThat(reader.read(shown)).isEqualTo(Received.FRAME);
            Sighting seen = finder.detect(shown).orElseThrow().sighting();
            assertThat(seen.distanceMm()).isBetween(AHEAD.distanceMm() - 30, AHEAD.distanceMm() + 30);
            assertThat(seen.bearingRad()).isBetween(AHEAD.bearingRad() - 0.01, AHEAD.bearingRad() + 0.01);
        }
    }

    @Test
    void aLargePictureIsMadeSmallerAndASmallOneIsNotEnlarged() throws IOException {
        preview.newest();
        read(new BufferedImage(1920, 1080, BufferedImage.TYPE_3BYTE_BGR));
        preview.offer(frame);
        assertThat(picture().getWidth()).isEqualTo(640);
        assertThat(picture().getHeight()).isEqualTo(360);

        clock.advance(Duration.ofSeconds(1));
        read(new BufferedImage(160, 120, BufferedImage.TYPE_BYTE_GRAY));
        preview.offer(frame);
        assertThat(picture().getWidth()).isEqualTo(160);
        assertThat(picture().getHeight()).isEqualTo(120);
    }

    @Test
    void nothingIsEncodedWithoutViewers() {
        preview.offer(frame);
        assertThat(encoded).hasValue(0);

        preview.newest();
        clock.advance(Duration.ofMillis(2999));
        preview.offer(frame);
        assertThat(encoded).hasValue(1);
        clock.advance(Duration.ofMillis(1));
        for (int second = 0; second < 60; second++) {
            preview.offer(frame);
            clock.advance(Duration.ofSeconds(1));
        }
        assertThat(encoded).hasValue(1);
        assertThat(shot().age()).isEqualTo(Duration.ofMillis(60_001));
    }

    @Test
    void atMostOnePictureIsEncodedInAQuarterOfASecond() {
        preview.newest();
        preview.offer(frame);
        clock.advance(SHORT_OF_A_TURN);
        preview.offer(frame);
        assertThat(encoded).hasValue(1);
        assertThat(shot().age()).isEqualTo(SHORT_OF_A_TURN);

        clock.advance(Duration.ofMillis(1));
        preview.offer(frame);
        assertThat(encoded).hasValue(2);
        assertThat(shot().age()).isZero();
    }

    @Test
    void theLastPictureStaysWhenItsCameraIsClosed() throws IOException {
        try (HttpCamera server = new HttpCamera();
                Clock cameras = new SystemClock()) {
            server.repeat(Scene.jpeg(Scene.of(AHEAD, 1)));
            preview.newest();
            CameraSettings settings = CameraSettings.of(CameraSource.parse(server.url()));
            try (VideoCamera camera = VideoCamera.open(OpenCv.vision(), settings, cameras, preview::offer)) {
                await().until(() -> preview.newest().isPresent());
                assertThat(camera.newest().frame()).isPositive();
            }
        }
        clock.advance(Duration.ofMinutes(2));
        assertThat(shot().age()).isEqualTo(Duration.ofMinutes(2));
        assertThat(picture().getWidth()).isEqualTo(640);
    }

    @Test
    void aViewerThatFailsDoesNotBlindTheCamera() throws IOException {
        try (HttpCamera server = new HttpCamera();
                Clock cameras = new SystemClock()) {
            server.repeat(Scene.jpeg(Scene.of(AHEAD, 1)));
            CameraSettings settings =
                    CameraSettings.of(CameraSource.parse(server.url())).withStaleAfter(Duration.ofSeconds(20));
            AtomicInteger failures = new AtomicInteger();
            try (VideoCamera camera = VideoCamera.open(OpenCv.vision(), settings, cameras, shown -> {
                failures.incrementAndGet();
                throw new IllegalStateException("this viewer fails");
            })) {
                await().until(() ->
                        failures.get() > 2 && camera.newest().sighting().isPresent());
                assertThat(camera.newest().health().reason()).isEmpty();
            }
        }
    }
}
