package org.evoloop.roomba.camera.vision;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.evoloop.roomba.camera.CameraSource;
import org.evoloop.roomba.camera.Scene;
import org.evoloop.roomba.camera.Sighting;
import org.evoloop.roomba.camera.vision.FrameReader.Received;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A recording does not exceed its size limit, and its contents up to then can be viewed. */
class RecordingTest {
    private static final int FRAMES_PER_SECOND = 15;
    private static final long NANOS_BETWEEN = 1_000_000_000L / FRAMES_PER_SECOND;

    private final Vision vision = OpenCv.vision();

    @TempDir
    Path folder;

    private Path record(int frames, long mostBytes) throws IOException {
        Path picture = folder.resolve("0.jpg");
        Files.write(picture, Scene.jpeg(Scene.of(new Sighting(900, 0), 1)));
        Path file = folder.resolve("seen.avi");
        try (FrameReader reader = vision.open(CameraSource.parse(picture.toString()), FrameSize.DEFAULT);
                Frame frame = vision.newFrame();
                FrameRecorder recorder = vision.recorder(file, FRAMES_PER_SECOND, mostBytes)) {
            assertThat(reader.read(frame)).isEqualTo(Received.FRAME);
            for (int count = 0; count < frames; count++) {
                recorder.write(frame, count * NANOS_BETWEEN, Optional.empty(), List.of("frame " + count));
            }
        }
        return file;
    }

    private int framesIn(Path file) {
        int frames = 0;
        try (FrameReader reader = vision.open(CameraSource.parse(file.toString()), FrameSize.DEFAULT);
                Frame frame = vision.newFrame()) {
            while (reader.read(frame) == Received.FRAME) {
                frames++;
            }
        }
        return frames;
    }

    @Test
    void itEndsAtItsLimitAndCanBeSeen() throws IOException {
        Path file = record(2_000, 2_000_000);
        assertThat(Files.size(file)).isBetween(500_000L, 2_000_000L);
        assertThat(framesIn(file)).isBetween(10, 1_999);
    }

    @Test
    void aShortOneIsWhole() throws IOException {
        assertThat(framesIn(record(18 * FRAMES_PER_SECOND, 50_000_000))).isEqualTo(18 * FRAMES_PER_SECOND);
    }

    @Test
    void eighteenSecondsTakeAFewMegabytes() throws IOException {
        assertThat(Files.size(record(18 * FRAMES_PER_SECOND, 50_000_000))).isLessThan(12_000_000);
    }
}
