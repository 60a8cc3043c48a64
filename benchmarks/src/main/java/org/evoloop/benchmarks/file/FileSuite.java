package org.evoloop.benchmarks.file;

import java.io.IOException;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.evoloop.benchmarks.report.Figures;
import org.evoloop.benchmarks.report.Fork;
import org.evoloop.benchmarks.report.Row;
import org.evoloop.benchmarks.report.Started;
import org.evoloop.benchmarks.report.Suite;

/** A device file against the same in Java: its start, its memory, and an event on its way through it. */
public final class FileSuite implements Suite {
    private static final Path LIGHT_BULB = Path.of("lightbulb-example", "target", "lightbulb-example.jar");
    private static final Path TOOL = Path.of("framework", "models", "target", "evoloop-models.jar");
    private static final String FIRST_EVENT = "new_current_state: on";

    /** As long as it takes to connect to a broker on this computer. */
    private static final Duration CONNECTED = Duration.ofSeconds(3);

    @Override
    public String name() {
        return "file";
    }

    @Override
    public List<Row> measure(boolean quick) throws Exception {
        List<Started> files = new ArrayList<>();
        List<Started> programs = new ArrayList<>();
        for (int start = 0; start < (quick ? 3 : 9); start++) {
            programs.add(Started.of(LIGHT_BULB, List.of(), "start\nswitch\n", FIRST_EVENT, Duration.ZERO));
            files.add(file(List.of(), Duration.ZERO));
        }
        List<Row> rows = new ArrayList<>();
        rows.add(new Row(
                "start of a device file to the first event",
                "s",
                Started.medianSeconds(files),
                Row.Goal.atMostTimes(1.3, "the light bulb in Java", Started.medianSeconds(programs))));
        Optional<String> broker = broker();
        if (broker.isPresent()) {
            rows.add(
                    new Row("its resident memory with MQTT and page", "MB", memory(broker.get()), Row.Goal.atMost(85)));
        } else {
            System.err.println("evoloop: there is no mosquitto, so the memory with MQTT is not measured");
        }
        Figures events = Fork.shipped(FileWiring.class, List.of("20"), quick ? "2000" : "10000")
                .figures();
        rows.add(new Row(
                "an event through a device file, median",
                "us",
                events.get("file p50"),
                Row.Goal.atMostTimes(1.2, "the same in Java", events.get("java p50")),
                Map.of("p99", events.get("file p99"), "p99 in Java", events.get("java p99"))));
        rows.add(new Row(
                "the same, allocated",
                "B",
                Math.rint(events.get("file bytes")),
                // No more, but for what idle threads allocate meanwhile.
                Row.Goal.atMostTimes(1.01, "the same in Java", Math.rint(events.get("java bytes")))));
        return rows;
    }

    private static Started file(List<String> more, Duration lives) throws IOException, InterruptedException {
        Path home = Path.of(System.getProperty("evoloop.home", ""));
        List<String> arguments = new ArrayList<>(List.of(
                "device",
                "run",
                home.resolve("devices/light-bulb/light-bulb.yaml").toString(),
                "--simulate",
                "--start"));
        arguments.addAll(more);
        return Started.of(TOOL, arguments, "press switch\n", FIRST_EVENT, lives);
    }

    /** Debian puts the broker into a directory that is only on root's path. */
    private static Optional<String> broker() {
        return Stream.of((System.getenv("PATH") + ":/usr/sbin").split(":"))
                .map(folder -> Path.of(folder, "mosquitto"))
                .filter(Files::isExecutable)
                .map(Path::toString)
                .findFirst();
    }

    private static double memory(String mosquitto) throws IOException, InterruptedException {
        int mqtt = freePort();
        Process broker = new ProcessBuilder(mosquitto, "-p", Integer.toString(mqtt))
                .redirectErrorStream(true)
                .redirectOutput(ProcessBuilder.Redirect.DISCARD)
                .start();
        try {
            List<String> options =
                    List.of("--mqtt", "mqtt://127.0.0.1:" + mqtt, "--page", Integer.toString(freePort()));
            return file(options, CONNECTED).megabytes();
        } finally {
            broker.destroy();
        }
    }

    private static int freePort() throws IOException {
        try (ServerSocket probe = new ServerSocket(0)) {
            return probe.getLocalPort();
        }
    }
}
