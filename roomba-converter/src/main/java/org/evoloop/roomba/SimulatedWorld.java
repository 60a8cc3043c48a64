package org.evoloop.roomba;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.io.Writer;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import org.evoloop.roomba.simulator.SimulatorServer;
import org.evoloop.roomba.simulator.WorldCommands;
import org.evoloop.roomba.simulator.drawing.RoomDrawing;
import org.evoloop.roomba.simulator.drawing.Trail;
import org.evoloop.roomba.simulator.robot.RobotOptions;
import org.evoloop.roomba.simulator.room.Room;
import org.evoloop.roomba.simulator.room.RoomFile;
import org.evoloop.roomba.simulator.webcam.Webcam;
import org.evoloop.roomba.simulator.webcam.WebcamOptions;
import org.evoloop.time.Clock;
import org.evoloop.time.SystemClock;

/**
 * A simulated robot at a serial port, and its environment, controlled by the simulator's text commands.
 *
 * <p>Threading: thread-safe.
 */
interface SimulatedWorld extends AutoCloseable {
    String ROOM = "demo-room.txt";
    String DRAWING = "drawing.svg";

    /** In the robot's time: as many as two slow cores can render and process when it runs four times as fast. */
    double CAMERA_FRAMES_PER_SECOND = 8;

    /** The robot's serial port. */
    Path port();

    /** Carries out one of the simulator's text commands and returns its one-line answer. */
    String execute(String line);

    @Override
    void close();

    /** The address of its camera; empty if it has none. */
    Optional<URI> camera();

    /** Draws the room, the robot's path and its camera's present view. */
    void draw(Path file) throws IOException;

    /** The drawing as SVG, while it runs; empty if it runs in another process. */
    default String drawn() {
        return "";
    }

    /**
     * A room for a robot with a camera, with a marker; the scenarios' starting point is 0.4 m in front of it.
     *
     * @throws IOException if it cannot be written
     */
    private static Path markedRoom(Path folder) throws IOException {
        Path file = folder.resolve(ROOM);
        try (InputStream room = Objects.requireNonNull(SimulatedWorld.class.getResourceAsStream(ROOM), ROOM)) {
            Files.copy(room, file);
        }
        return file;
    }

    /**
     * A robot in this process.
     *
     * @param camera whether it has a camera, in a room with a marker; otherwise it is on an open plain
     * @throws IOException if this system has no pseudo-terminals
     */
    static SimulatedWorld inThisProcess(double speed, boolean camera) throws IOException {
        Path folder = Files.createTempDirectory("evoloop");
        return inThisProcess(folder, speed, camera, camera ? RoomFile.read(markedRoom(folder)) : Room.OPEN);
    }

    /**
     * A robot in this process, in a room.
     *
     * @param camera whether it has a camera
     * @throws IOException if this system has no pseudo-terminals
     */
    static SimulatedWorld inThisProcess(double speed, boolean camera, Room room) throws IOException {
        return inThisProcess(Files.createTempDirectory("evoloop"), speed, camera, room);
    }

    private static SimulatedWorld inThisProcess(Path folder, double speed, boolean camera, Room room)
            throws IOException {
        Clock clock = new SystemClock();
        Trail trail = new Trail();
        SimulatorServer server = SimulatorServer.start(
                folder.resolve("roomba"),
                RobotOptions.builder().room(room).build(),
                clock,
                speed,
                trail,
                camera
                        ? Optional.of(WebcamOptions.defaults().withFramesPerSecond(CAMERA_FRAMES_PER_SECOND))
                        : Optional.empty());
        WorldCommands commands = new WorldCommands(server);
        return new SimulatedWorld() {
            @Override
            public Optional<URI> camera() {
                return server.camera().map(Webcam::url);
            }

            @Override
            public void draw(Path file) throws IOException {
                Files.writeString(file, drawn());
            }

            @Override
            public String drawn() {
                double view = server.camera()
                        .map(webcam -> webcam.options().eye().fieldOfViewDeg())
                        .orElse(0.0);
                return RoomDrawing.svg(server.robot().state(), trail, view);
            }

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
     * A robot in a process of its own, connected only by the port and its camera's address.
     *
     * @param camera whether it has a camera, in a room with a marker
     * @param options further options of the simulator, such as {@code --baud=19200}
     * @throws IOException if it cannot be started
     */
    static SimulatedWorld inAnotherProcess(double speed, boolean camera, String... options) throws IOException {
        Path folder = Files.createTempDirectory("evoloop");
        Path port = folder.resolve("roomba");
        Path drawing = folder.resolve(DRAWING);
        List<String> command = new ArrayList<>(List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                // As in the program's manifest, which counts only with -jar.
                "--enable-native-access=ALL-UNNAMED",
                "-cp",
                System.getProperty("java.class.path"),
                Main.class.getName(),
                "simulator",
                "--link=" + port,
                "--speed=" + speed,
                "--svg=" + drawing));
        command.addAll(List.of(options));
        if (camera) {
            command.addAll(
                    List.of("--room=" + markedRoom(folder), "--camera=0", "--camera-fps=" + CAMERA_FRAMES_PER_SECOND));
        }
        Process process = new ProcessBuilder(command)
                .redirectError(ProcessBuilder.Redirect.INHERIT)
                .start();
        Writer input = process.outputWriter(StandardCharsets.UTF_8);
        BufferedReader output =
                new BufferedReader(new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8));
        String ready = output.readLine();
        String sees = camera ? output.readLine() : "camera ";
        if (ready == null || !ready.startsWith("ready ") || sees == null || !sees.startsWith("camera ")) {
            process.destroy();
            delete(folder);
            throw new IOException("the simulator did not start; its messages are above");
        }
        Optional<URI> url = camera ? Optional.of(URI.create(sees.substring("camera ".length()))) : Optional.empty();
        return new SimulatedWorld() {
            @Override
            public Optional<URI> camera() {
                return url;
            }

            @Override
            public void draw(Path file) throws IOException {
                // It draws when it ends.
                end();
                Files.copy(drawing, file, StandardCopyOption.REPLACE_EXISTING);
            }

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
                end();
                delete(folder);
            }

            private void end() {
                process.destroy();
                try {
                    if (!process.waitFor(5, TimeUnit.SECONDS)) {
                        process.destroyForcibly();
                    }
                } catch (InterruptedException hurry) {
                    process.destroyForcibly();
                    Thread.currentThread().interrupt();
                }
            }
        };
    }

    private static void delete(Path folder) {
        try {
            for (String file : List.of("roomba", ROOM, DRAWING)) {
                Files.deleteIfExists(folder.resolve(file));
            }
            Files.deleteIfExists(folder);
        } catch (IOException leftBehind) {
            // A leftover link in the folder for temporary files does no harm.
            folder.toFile().deleteOnExit();
        }
    }
}
