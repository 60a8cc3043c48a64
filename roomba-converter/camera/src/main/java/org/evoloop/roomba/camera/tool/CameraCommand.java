package org.evoloop.roomba.camera.tool;

import java.io.PrintWriter;
import java.time.Duration;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.atomic.AtomicReference;
import org.evoloop.roomba.camera.CameraHealth;
import org.evoloop.roomba.camera.CameraSource;
import org.evoloop.roomba.camera.Look;
import org.evoloop.roomba.camera.live.CameraSettings;
import org.evoloop.roomba.camera.live.VideoCamera;
import org.evoloop.roomba.camera.vision.OpenCv;
import org.evoloop.roomba.camera.vision.Vision;
import org.evoloop.time.Clock;
import org.evoloop.time.SystemClock;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** Tests a camera: its condition, the rate and age of its frames, and where it sees the marker. */
@Command(
        name = "camera",
        description = "Tries a camera: frames a second, their age, and where it sees the marker, second by second.",
        mixinStandardHelpOptions = true)
public final class CameraCommand implements Callable<Integer> {
    private static final int CANNOT_SEE = 1;
    private static final Duration BETWEEN_LINES = Duration.ofSeconds(1);

    @Parameters(
            paramLabel = "SOURCE",
            description = "A device such as /dev/video0 or 0, the URL of an HTTP camera, a video, or pictures such as "
                    + "frames/%%04d.png.")
    private String source = "";

    @Option(
            names = "--seconds",
            paramLabel = "N",
            defaultValue = "10",
            description = "How long to look; a recording is looked at to its end (default: ${DEFAULT-VALUE}).")
    private int seconds;

    @Mixin
    private final CameraOptions options = new CameraOptions();

    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it before the call
    private CommandSpec spec;

    /** Returns status 0 if the camera showed a frame, and 1 if not. */
    @Override
    public Integer call() throws InterruptedException {
        if (seconds < 1 || seconds > 86_400) {
            throw new IllegalArgumentException("--seconds is " + seconds + ", allowed is 1 to 86400");
        }
        CameraSettings settings = options.read(CameraSource.parse(source));
        Vision vision = OpenCv.vision();
        PrintWriter out = spec.commandLine().getOut();
        try (Clock clock = new SystemClock();
                VideoCamera camera = VideoCamera.open(vision, settings, clock)) {
            out.println("OpenCV " + vision.version() + ", camera " + settings.source());
            out.flush();
            return watch(camera, settings, clock, out);
        }
    }

    private int watch(VideoCamera camera, CameraSettings settings, Clock clock, PrintWriter out)
            throws InterruptedException {
        AtomicReference<Optional<Look>> marked = new AtomicReference<>(Optional.empty());
        Runnable unregister = camera.onLook(() -> {
            Look look = camera.newest();
            if (look.sighting().isPresent()) {
                marked.set(Optional.of(look));
            }
        });
        VideoCamera.Counts before = camera.counts();
        Duration cpuBefore = cpu();
        for (int second = 1; second <= seconds; second++) {
            clock.sleep(BETWEEN_LINES);
            Look look = camera.newest();
            VideoCamera.Counts counts = camera.counts();
            Duration cpu = cpu();
            out.println(line(
                    look,
                    marked.getAndSet(Optional.empty()),
                    counts.looked() - before.looked(),
                    cpu.minus(cpuBefore),
                    clock));
            out.flush();
            before = counts;
            cpuBefore = cpu;
            if (!settings.source().isLive() && look.health().state() == CameraHealth.Condition.GONE) {
                break;
            }
        }
        unregister.run();
        VideoCamera.Counts counts = camera.counts();
        out.printf(
                Locale.ROOT,
                "%d frames, the marker in %d of them, %d damaged%n",
                counts.looked(),
                counts.detections(),
                counts.damaged());
        out.flush();
        return counts.looked() > 0 ? 0 : CANNOT_SEE;
    }

    private static String line(Look look, Optional<Look> marked, long frames, Duration cpu, Clock clock) {
        String state = look.health().state().name().toLowerCase(Locale.ROOT);
        if (!look.health().reason().isEmpty()) {
            state += ": " + look.health().reason();
        }
        if (frames == 0) {
            return state;
        }
        String sees = marked.flatMap(Look::sighting)
                .map(sighting -> String.format(
                        Locale.ROOT,
                        "marker at %.0f mm, %+.1f degrees",
                        sighting.distanceMm(),
                        Math.toDegrees(sighting.bearingRad())))
                .orElse("no marker");
        return String.format(
                Locale.ROOT,
                "%s; %d frames, the newest %d ms old, %.1f ms of CPU each; %s",
                state,
                frames,
                (clock.nanoTime() - look.takenNanos()) / 1_000_000,
                cpu.toNanos() / 1e6 / frames,
                sees);
    }

    private static Duration cpu() {
        return ProcessHandle.current().info().totalCpuDuration().orElse(Duration.ZERO);
    }
}
