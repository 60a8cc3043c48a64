package org.evoloop.benchmarks.device;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.evoloop.benchmarks.report.Fork;
import org.evoloop.benchmarks.report.ResidentMemory;
import org.evoloop.benchmarks.report.Row;
import org.evoloop.benchmarks.report.Suite;

/** From the press of a button to the command, and from the start of the program to its first event. */
public final class DeviceSuite implements Suite {
    @Override
    public String name() {
        return "device";
    }

    @Override
    public List<Row> measure(boolean quick) throws Exception {
        List<Row> rows = new ArrayList<>(presses(quick ? "10" : "60"));
        Fork version = Fork.java("-version");
        double[] starts = new double[quick ? 3 : 9];
        double[] versions = new double[starts.length];
        double megabytes = 0;
        for (int start = 0; start < starts.length; start++) {
            versions[start] = version.wallSeconds();
            Started started = start();
            starts[start] = started.seconds();
            megabytes = Math.max(megabytes, started.megabytes());
        }
        Arrays.sort(starts);
        Arrays.sort(versions);
        rows.add(new Row(
                "start of the Roomba converter to the first event",
                "s",
                starts[starts.length / 2],
                Row.Goal.atMostTimes(10, "java -version", versions[versions.length / 2])));
        rows.add(new Row("its resident memory", "MB", megabytes, Row.Goal.atMost(90)));
        return rows;
    }

    private static List<Row> presses(String times) throws IOException, InterruptedException {
        return PressWay.rows(
                Fork.shipped(PressToCommand.class, List.of("0"), times).figures());
    }

    private record Started(double seconds, double megabytes) {}

    /**
     * Starts the program with a simulated robot that is already running; a press of its controller's button is the
     * first event.
     */
    private static Started start() throws IOException {
        Path folder = Files.createTempDirectory("evoloop");
        Path port = folder.resolve("roomba");
        Process robot = program("simulator", "--link", port.toString());
        try {
            BufferedReader ready = robot.inputReader(StandardCharsets.UTF_8);
            if (ready.readLine() == null) {
                throw new IOException("the simulator did not start");
            }
            long begun = System.nanoTime();
            Process converter = program("--port", port.toString());
            try (Writer console = converter.outputWriter(StandardCharsets.UTF_8);
                    BufferedReader transcript = new BufferedReader(
                            new InputStreamReader(converter.getErrorStream(), StandardCharsets.UTF_8));
                    BufferedReader output = converter.inputReader(StandardCharsets.UTF_8)) {
                console.write("start\npress clean\n");
                console.flush();
                awaitLine(output, transcript, "new_current_state: On");
                double seconds = (System.nanoTime() - begun) / 1e9;
                return new Started(seconds, ResidentMemory.of(converter.pid()));
            } finally {
                converter.destroy();
            }
        } finally {
            robot.destroy();
            Files.deleteIfExists(port);
            Files.deleteIfExists(folder);
        }
    }

    /** The transcript goes to only one of the two streams, but both must be read. */
    private static void awaitLine(BufferedReader output, BufferedReader other, String end) throws IOException {
        for (String line = output.readLine(); line != null; line = output.readLine()) {
            if (line.contains(end)) {
                return;
            }
        }
        throw new IOException("the converter ended before its first event: " + other.readLine());
    }

    private static Process program(String... arguments) throws IOException {
        List<String> command = new ArrayList<>(
                List.of(Path.of(System.getProperty("java.home"), "bin", "java").toString()));
        String home = System.getProperty("evoloop.home", "");
        command.addAll(Fork.SHIPPED_OPTIONS);
        command.add("-XX:SharedArchiveFile=" + Path.of(home, "target", "roomba-converter.jsa"));
        command.add("-Xlog:cds=off");
        command.add("-Xlog:cds+dynamic=off");
        command.add("-Devoloop.home=" + home);
        command.addAll(List.of(
                "-jar",
                Path.of(home, "roomba-converter", "target", "roomba-converter.jar")
                        .toString()));
        command.addAll(List.of(arguments));
        return new ProcessBuilder(command).start();
    }
}
