package org.evoloop.roomba.camera.live;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.evoloop.roomba.camera.CameraHealth.Condition;
import org.evoloop.roomba.camera.CameraSource;
import org.evoloop.roomba.camera.HttpCamera;
import org.evoloop.roomba.camera.Look;
import org.evoloop.roomba.camera.Scene;
import org.evoloop.roomba.camera.Sighting;
import org.evoloop.roomba.camera.vision.OpenCv;
import org.evoloop.time.Clock;
import org.evoloop.time.SystemClock;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** Cameras read by OpenCV, over HTTP and from files. */
@Timeout(60)
class VideoCameraTest {
    private static final Sighting AHEAD = new Sighting(800, 0.1);
    private static final byte[] MARKER = Scene.jpeg(Scene.of(AHEAD, 1));
    private static final byte[] WALL = Scene.jpeg(Scene.empty(1));

    private final Clock clock = new SystemClock();

    @TempDir
    Path folder;

    @AfterEach
    void close() {
        clock.close();
    }

    private VideoCamera open(String source) {
        return open(CameraSettings.of(CameraSource.parse(source)).withStaleAfter(Duration.ofSeconds(1)));
    }

    private VideoCamera open(CameraSettings settings) {
        return VideoCamera.open(OpenCv.vision(), settings, clock);
    }

    private static void awaitState(VideoCamera camera, Condition state) {
        await().atMost(20, TimeUnit.SECONDS)
                .untilAsserted(
                        () -> assertThat(camera.newest().health().state()).isEqualTo(state));
    }

    private static Look awaitMarker(VideoCamera camera) {
        return await().atMost(20, TimeUnit.SECONDS)
                .until(camera::newest, look -> look.sighting().isPresent());
    }

    @Test
    void seesTheMarkerOverHttp() throws IOException {
        try (HttpCamera server = new HttpCamera();
                VideoCamera camera = open(
                        CameraSettings.of(CameraSource.parse(server.url())).withStaleAfter(Duration.ofSeconds(30)))) {
            server.repeat(MARKER);

            Look look = awaitMarker(camera);

            assertThat(look.health().state()).isEqualTo(Condition.SEEING);
            assertThat(look.sighting().orElseThrow().distanceMm()).isCloseTo(AHEAD.distanceMm(), within(30.0));
            assertThat(look.sighting().orElseThrow().bearingRad()).isCloseTo(AHEAD.bearingRad(), within(0.01));
            assertThat(clock.nanoTime() - look.takenNanos())
                    .isBetween(0L, Duration.ofSeconds(5).toNanos());
        }
    }

    @Test
    void believesNothingThatOneFrameShows() throws Exception {
        try (HttpCamera server = new HttpCamera();
                VideoCamera camera = open(
                        CameraSettings.of(CameraSource.parse(server.url())).withStaleAfter(Duration.ofSeconds(30)))) {
            CountDownLatch looks = new CountDownLatch(3);
            camera.onLook(() -> {
                assertThat(camera.newest().sighting()).isEmpty();
                looks.countDown();
            });
            // Decoders buffer some frames, so pictures of the wall follow until all were processed.
            server.send(WALL);
            server.send(MARKER);
            server.repeat(WALL);

            assertThat(looks.await(20, TimeUnit.SECONDS)).isTrue();
            assertThat(camera.newest().sighting()).isEmpty();
        }
    }

    @Test
    void hasStalledWhenTheServerFallsSilentAndSeesAgainWhenItContinues() throws IOException {
        try (HttpCamera server = new HttpCamera();
                VideoCamera camera = open(server.url())) {
            server.repeat(MARKER);
            awaitMarker(camera);

            server.pause();
            awaitState(camera, Condition.STALLED);
            assertThat(camera.newest().health().reason())
                    .startsWith("camera " + server.url() + " has sent no frame for ")
                    .endsWith("; check its cable and power");

            server.repeat(MARKER);
            awaitState(camera, Condition.SEEING);
        }
    }

    @Test
    void isGoneWhenTheServerHangsUpAndOpensItAgain() throws IOException {
        try (HttpCamera server = new HttpCamera();
                VideoCamera camera = open(server.url())) {
            server.repeat(MARKER);
            awaitMarker(camera);

            server.refuse();
            awaitState(camera, Condition.GONE);

            server.repeat(MARKER);
            awaitState(camera, Condition.SEEING);
            assertThat(server.connections()).isGreaterThan(1);
        }
    }

    @Test
    void isGoneWhileThereIsNoAnswer() throws IOException {
        String url;
        try (HttpCamera server = new HttpCamera()) {
            url = server.url();
        }
        try (VideoCamera camera = open(url)) {
            awaitState(camera, Condition.GONE);
            assertThat(camera.newest().health().reason())
                    .isEqualTo("camera " + url + " cannot be opened; does exactly that address answer with Motion "
                            + "JPEG, not with a page that shows it?");
            assertThat(camera.newest().frame()).isZero();
        }
    }

    @Test
    void countsDamagedFramesAndSeesTheOthers() throws IOException {
        byte[] garbage = new byte[4000];
        try (HttpCamera server = new HttpCamera();
                VideoCamera camera = open(server.url())) {
            server.repeat(MARKER, MARKER, MARKER, garbage);

            await().atMost(20, TimeUnit.SECONDS).until(() -> camera.counts().damaged() > 2);
            awaitMarker(camera);
        }
    }

    @Test
    void closesWhileTheDriverWaits() throws IOException {
        try (HttpCamera server = new HttpCamera()) {
            VideoCamera camera = open(server.url());
            server.repeat(MARKER);
            awaitMarker(camera);
            server.pause();
            awaitState(camera, Condition.STALLED);

            long before = System.nanoTime();
            camera.close();
            camera.close();

            assertThat(Duration.ofNanos(System.nanoTime() - before)).isLessThan(Duration.ofSeconds(5));
            assertThat(camera.newest().health().state()).isEqualTo(Condition.CLOSED);
        }
    }

    @Test
    void looksAtEveryPictureOfASequence() throws IOException {
        Scene.write(
                folder,
                "%02d.png",
                Scene.empty(1),
                Scene.of(new Sighting(1000, 0), 2),
                Scene.of(new Sighting(980, 0), 3),
                Scene.of(new Sighting(960, 0), 4));
        try (VideoCamera camera = open(folder.resolve("%02d.png").toString())) {
            awaitState(camera, Condition.GONE);
            assertThat(camera.counts()).isEqualTo(new VideoCamera.Counts(4, 3, 0));
            assertThat(camera.newest().sighting().orElseThrow().distanceMm()).isCloseTo(960, within(20.0));
        }
    }

    @Test
    void countsPicturesThatEndEarly() throws IOException {
        for (int i = 0; i < 4; i++) {
            byte[] whole = Scene.jpeg(Scene.of(new Sighting(600, 0), i));
            byte[] file = i == 2 ? java.util.Arrays.copyOf(whole, whole.length / 2) : whole;
            Files.write(folder.resolve(i + ".jpg"), file);
        }
        try (VideoCamera camera = open(folder.resolve("%d.jpg").toString())) {
            awaitState(camera, Condition.GONE);
            assertThat(camera.counts()).isEqualTo(new VideoCamera.Counts(3, 3, 1));
        }
    }

    @Test
    void whatItRecordsIsAVideoThatItCanRead() throws IOException {
        Path video = folder.resolve("seen.avi");
        try (HttpCamera server = new HttpCamera();
                VideoCamera camera =
                        open(CameraSettings.of(CameraSource.parse(server.url())).withRecord(video))) {
            server.repeat(MARKER);
            awaitMarker(camera);
            await().atMost(20, TimeUnit.SECONDS).until(() -> camera.newest().frame() > 20);
        }
        try (VideoCamera camera = open(video.toString())) {
            awaitState(camera, Condition.GONE);
            assertThat(camera.counts().looked()).isPositive();
            assertThat(camera.counts().detections()).isEqualTo(camera.counts().looked());
        }
    }

    @Test
    void reportsWhyADeviceOrFileCannotBeOpened() {
        for (String source : List.of("/dev/video99", "/nowhere/film.avi")) {
            try (VideoCamera camera = open(source)) {
                awaitState(camera, Condition.GONE);
                assertThat(camera.newest().health().reason()).startsWith("camera " + source + " does not exist; ");
            }
        }
    }
}
