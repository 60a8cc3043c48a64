package org.evoloop.roomba;

import java.io.IOException;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.awaitility.Awaitility;

/** A simulated robot in a process of its own, with its true state and its converters. */
final class OtherRobot implements AutoCloseable {
    /** The truth at one moment of the robot's time. */
    record Truth(long millis, String activity, String mode, double x, double y, double left, double right) {
        boolean drives() {
            return left != 0 || right != 0;
        }

        boolean isPassive() {
            return mode.equals("passive");
        }

        double mmFrom(Truth earlier) {
            return Math.hypot(x - earlier.x, y - earlier.y);
        }
    }

    private final SimulatedWorld world;
    private final List<Process> converters = new ArrayList<>();

    /** @param options of the simulator */
    OtherRobot(String... options) throws IOException {
        world = SimulatedWorld.inAnotherProcess(1, false, options);
    }

    String port() {
        return world.port().toString();
    }

    /** Starts a converter in a process of its own, and opens its loop; its output is appended to {@code log}. */
    Process convert(Path log, String... options) throws IOException {
        List<String> arguments = new ArrayList<>(List.of("--port", port(), "--start"));
        arguments.addAll(List.of(options));
        Process converter = Program.startWithLog(log, arguments.toArray(String[]::new));
        converters.add(converter);
        return converter;
    }

    static void type(Process converter, String lines) throws IOException {
        Writer input = converter.outputWriter(StandardCharsets.UTF_8);
        input.write(lines);
        input.flush();
    }

    String execute(String command) {
        return world.execute(command);
    }

    Truth truth() {
        String json = world.execute("state");
        return new Truth(
                Long.parseLong(value(json, "timeMillis")),
                value(json, "activity"),
                value(json, "oiMode"),
                number(json, "xMm"),
                number(json, "yMm"),
                number(json, "leftMmPerS"),
                number(json, "rightMmPerS"));
    }

    private static double number(String json, String key) {
        return Double.parseDouble(value(json, key));
    }

    private static String value(String json, String key) {
        Matcher found = Pattern.compile("\"" + key + "\":\"?([^,\"]*)").matcher(json);
        if (!found.find()) {
            throw new AssertionError("no " + key + " in " + json);
        }
        return found.group(1);
    }

    /** Waits for the first truth that satisfies this. */
    Truth await(String what, Predicate<Truth> wanted) {
        return Awaitility.await(what)
                .pollDelay(Duration.ZERO)
                .pollInterval(Duration.ofMillis(5))
                .atMost(Duration.ofSeconds(60))
                .until(this::truth, wanted);
    }

    /** Ends all processes. */
    @Override
    public void close() {
        converters.forEach(Process::destroyForcibly);
        converters.forEach(converter -> converter.onExit().join());
        world.close();
    }
}
