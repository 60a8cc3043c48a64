package org.evoloop.roomba.camera.vision;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.evoloop.roomba.camera.CameraModel;
import org.evoloop.roomba.camera.CameraSource;
import org.evoloop.roomba.camera.MarkerSpec;
import org.evoloop.roomba.camera.Scene;
import org.evoloop.roomba.camera.Sighting;
import org.evoloop.roomba.camera.vision.FrameReader.Received;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** Reading, finding and recording do not leak native memory: each leaked frame would be 225 kB. */
@EnabledOnOs(OS.LINUX)
class NativeMemoryTest {
    private static final int PICTURES = 50;

    /** Frames during which buffers fill and Java's compilers run. */
    private static final int WARM_UP = 250;

    /** By how much Java's own heap may grow meanwhile. */
    private static final long ALLOWED_KB = 100_000;

    private final Vision vision = OpenCv.vision();

    @TempDir
    Path folder;

    @Test
    void isFlatOverAThousandFrames() throws IOException {
        assertFlat(1_000);
    }

    @Test
    @Tag("slow")
    void isFlatOverAHundredThousandFrames() throws IOException {
        assertFlat(100_000);
    }

    private void assertFlat(int frames) throws IOException {
        for (int i = 0; i < PICTURES; i++) {
            Files.write(folder.resolve(i + ".jpg"), Scene.jpeg(half(Scene.of(new Sighting(700 + i, 0), i))));
        }
        try (MarkerFinder finder = vision.finder(MarkerSpec.DEFAULT, CameraModel.DEFAULT);
                Frame frame = vision.newFrame()) {
            byte[] pixels = Scene.pixels(Scene.of(new Sighting(900, 0), 1));
            read(WARM_UP, finder, frame, pixels);
            long before = residentKb();
            read(frames, finder, frame, pixels);
            assertThat(residentKb() - before).isLessThan(ALLOWED_KB);
        }
    }

    /** Opens the sequence again and again, like a camera that disconnects and reconnects. */
    private void read(int frames, MarkerFinder finder, Frame frame, byte[] pixels) {
        CameraSource source = CameraSource.parse(folder.resolve("%d.jpg").toString());
        for (int done = 0; done < frames; done += PICTURES) {
            try (FrameReader reader = vision.open(source, FrameSize.DEFAULT);
                    FrameRecorder recorder = vision.recorder(folder.resolve("seen.avi"), 15, 50_000_000)) {
                for (int i = 0; i < PICTURES; i++) {
                    assertThat(reader.read(frame)).isEqualTo(Received.FRAME);
                    Optional<Detection> seen = finder.detect(frame);
                    assertThat(seen).isPresent();
                    recorder.write(frame, i * 66_666_667L, seen, List.of("frame " + i));
                }
            }
            assertThat(finder.find(pixels, Scene.WIDTH, Scene.HEIGHT)).isPresent();
        }
    }

    private static BufferedImage half(BufferedImage picture) {
        BufferedImage half =
                new BufferedImage(picture.getWidth() / 2, picture.getHeight() / 2, BufferedImage.TYPE_3BYTE_BGR);
        Graphics2D painter = half.createGraphics();
        painter.drawImage(picture, 0, 0, half.getWidth(), half.getHeight(), null);
        painter.dispose();
        return half;
    }

    private static long residentKb() throws IOException {
        return Files.readAllLines(Path.of("/proc/self/status")).stream()
                .filter(line -> line.startsWith("VmRSS:"))
                .mapToLong(line -> Long.parseLong(line.replaceAll("\\D", "")))
                .findFirst()
                .orElseThrow();
    }
}
