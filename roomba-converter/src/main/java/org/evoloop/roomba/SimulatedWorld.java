package org.evoloop.roomba;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.evoloop.roomba.simulator.SimulatorServer;
import org.evoloop.roomba.simulator.WorldCommands;
import org.evoloop.roomba.simulator.robot.RobotOptions;
import org.evoloop.time.Clock;
import org.evoloop.time.SystemClock;

/**
 * A simulated robot at a serial port, and the people around it: they speak the simulator's text commands.
 *
 * <p>Threading: thread-safe.
 */
interface SimulatedWorld extends AutoCloseable {

    /** The robot's serial port. */
    Path port();

    /** Carries out one of the simulator's text commands and returns its one-line answer. */
    String execute(String line);

    @Override
    void close();

    /**
     * A robot in this process.
     *
     * @throws IOException if this system has no pseudo-terminals
     */
    static SimulatedWorld inThisProcess(double speed) throws IOException {
        Path folder = Files.createTempDirectory("evoloop");
        Clock clock = new SystemClock();
        SimulatorServer server = SimulatorServer.start(folder.resolve("roomba"), RobotOptions.defaults(), clock, speed);
        WorldCommands commands = new WorldCommands(server);
        return new SimulatedWorld() {
            @Override
            public Path port() {
                return server.path();
            }

            @Override
            public String execute(String line) {
                return commands.execute(line);
            }

            @Override
            public void close() {
                server.close();
                clock.close();
                delete(folder);
            }
        };
    }

    /**
     * A robot in a process of its own: nothing but the port joins it with whoever opens that.
     *
     * @throws IOException if it cannot be started
     */
    static SimulatedWorld inAnotherProcess(double speed) throws IOException {
        Path folder = Files.createTempDirectory("evoloop");
        Path port = folder.resolve("roomba");
        Process process = new ProcessBuilder(List.of(
                        Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                        "-cp",
                        System.getProperty("java.class.path"),
                        Main.class.getName(),
                        "simulator",
                        "--link",
                        port.toString(),
                        "--speed",
                        Double.toString(speed)))
                .redirectError(ProcessBuilder.Redirect.INHERIT)
                .start();
        Writer input = process.outputWriter(StandardCharsets.UTF_8);
        BufferedReader output =
                new BufferedReader(new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8));
        String ready = output.readLine();
        if (ready == null || !ready.startsWith("ready ")) {
            process.destroy();
            delete(folder);
            throw new IOException("the simulator did not start; its messages are above");
        }
        return new SimulatedWorld() {
            @Override
            public Path port() {
                return port;
            }

            @Override
            public synchronized String execute(String line) {
                try {
                    input.write(line + "\n");
                    input.flush();
                    String answer = output.readLine();
                    return answer == null ? "error: the simulator has ended" : answer;
                } catch (IOException gone) {
                    throw new UncheckedIOException("the simulator has ended", gone);
                }
            }

            @Override
            public void close() {
                process.destroy();
                try {
                    if (!process.waitFor(5, TimeUnit.SECONDS)) {
                        process.destroyForcibly();
                    }
                } catch (InterruptedException hurry) {
                    process.destroyForcibly();
                    Thread.currentThread().interrupt();
                }
                delete(folder);
            }
        };
    }

    private static void delete(Path folder) {
        try {
            Files.deleteIfExists(folder.resolve("roomba"));
            Files.deleteIfExists(folder);
        } catch (IOException leftBehind) {
            // A link in the folder for temporary files does no harm.
            folder.toFile().deleteOnExit();
        }
    }
}
