package org.evoloop.benchmarks.device;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.evoloop.benchmarks.report.Fork;
import org.evoloop.benchmarks.report.Row;
import org.evoloop.benchmarks.report.Started;
import org.evoloop.benchmarks.report.Suite;

/** From the press of a button to the command, and from the start of the program to its first event. */
public final class DeviceSuite implements Suite {
    private static final Path ROOMBA = Path.of("roomba-converter", "target", "roomba-converter.jar");

    @Override
    public String name() {
        return "device";
    }

    @Override
    public List<Row> measure(boolean quick) throws Exception {
        List<Row> rows = new ArrayList<>(presses(quick ? "10" : "60"));
        Fork version = Fork.java("-version");
        double[] versions = new double[quick ? 3 : 9];
        List<Started> starts = new ArrayList<>();
        for (int start = 0; start < versions.length; start++) {
            versions[start] = version.wallSeconds();
            starts.add(start());
        }
        Arrays.sort(versions);
        rows.add(new Row(
                "start of the Roomba converter to the first event",
                "s",
                Started.medianSeconds(starts),
                Row.Goal.atMostTimes(10, "java -version", versions[versions.length / 2])));
        rows.add(new Row("its resident memory", "MB", Started.mostMegabytes(starts), Row.Goal.atMost(90)));
        return rows;
    }

    private static List<Row> presses(String times) throws IOException, InterruptedException {
        return PressWay.rows(
                Fork.shipped(PressToCommand.class, List.of("0"), times).figures());
    }

    /**
     * Starts the program with a simulated robot that is already running; a press of its controller's button is the
     * first event.
     */
    private static Started start() throws IOException, InterruptedException {
        Path folder = Files.createTempDirectory("evoloop");
        Path port = folder.resolve("roomba");
        Process robot = Started.begin(ROOMBA, "simulator", "--link", port.toString());
        try {
            BufferedReader ready = robot.inputReader(StandardCharsets.UTF_8);
            if (ready.readLine() == null) {
                throw new IOException("the simulator did not start");
            }
            return Started.of(
                    ROOMBA,
                    List.of("--port", port.toString()),
                    "start\npress clean\n",
                    "new_current_state: On",
                    Duration.ZERO);
        } finally {
            robot.destroy();
            Files.deleteIfExists(port);
            Files.deleteIfExists(folder);
        }
    }
}
