package org.evoloop.roomba.simulator;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.Callable;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.evoloop.roomba.simulator.drawing.RoomDrawing;
import org.evoloop.roomba.simulator.drawing.Trail;
import org.evoloop.roomba.simulator.robot.RobotState;
import org.evoloop.time.Clock;
import org.evoloop.time.SystemClock;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/**
 * The simulator as a program: a robot at a port, and {@link WorldCommands} on standard input, answered on standard
 * output. It ends with code 0 by the command {@code exit}, the end of its input, SIGTERM or SIGINT; with {@code
 * --keep-running}, so that it can run in the background, the end of its input is no reason to end.
 *
 * @since 0.1
 */
@Command(
        name = "simulator",
        description = "Runs a simulated Roomba at a pseudo-terminal.",
        footer = {
            "",
            "The standard input takes one command per line; the standard output answers each:",
            "  press clean|spot|dock [MILLIS]   presses a button",
            "  lift, set-down                   holds the robot in the air, and sets it down",
            "  place X Y HEADING                carries it elsewhere",
            "  dock, undock                     puts it onto its dock, and off it",
            "  unplug, replug                   pulls its cable, and plugs it in again",
            "  move-marker X Y HEADING          hangs the marker elsewhere",
            "  cover-marker, uncover-marker     hangs a cloth over it, and takes it off",
            "  camera stall, camera resume      holds its pictures back, and sends them again",
            "  camera unplug, camera replug     pulls the camera's cable, and plugs it in again",
            "  camera damage P                  damages this share of its pictures, 0 to 1",
            "  state                            prints its true state in JSON",
            "  help, exit                       the end of the standard input ends it, too",
            "",
            "A room file has one object per line, in mm and in degrees counterclockwise",
            "from the x axis; # begins a comment:",
            "  wall X Y X Y               walls around a rectangle, by two corners",
            "  wall X Y X Y X Y ...       walls around a polygon",
            "  obstacle X Y X Y ...       something solid, a rectangle or polygon likewise",
            "  cliff X Y X Y ...          where there is no floor, likewise",
            "  dock X Y HEADING           where a docked robot stands and its heading;",
            "                             the dock itself is 176 mm ahead",
            "  start X Y HEADING          where it starts (default: the dock, else 0 0 0)",
            "  marker X Y HEADING [ID [SIDE [HEIGHT]]] [solid]",
            "                             an upright tag of 4x4_50 (default: 0, 150, 150),",
            "                             its middle HEIGHT above X Y; it faces HEADING;",
            "                             a solid one is an obstacle as wide as its board",
            "A wall or an obstacle may end with its appearance: color RRGGBB height MM"
        },
        mixinStandardHelpOptions = true)
public final class SimulatorCommand implements Callable<Integer> {
    private static final Logger LOG = LoggerFactory.getLogger(SimulatorCommand.class);

    private static final long END_LIMIT_SECONDS = 5;

    private final InputStream input;

    @Option(
            names = "--link",
            required = true,
            paramLabel = "PATH",
            description = "The symbolic link to create; programs open it as the robot's serial port.")
    private Path link = Path.of("");

    @Option(
            names = "--speed",
            paramLabel = "N",
            defaultValue = "1",
            description = "The speed of the simulation relative to real time (default: ${DEFAULT-VALUE}).")
    private double speed;

    @Option(
            names = "--keep-running",
            description = "Keeps running when the standard input ends, as in a service or with </dev/null; "
                    + "SIGTERM ends it.")
    private boolean keepRunning;

    @Option(
            names = "--svg",
            paramLabel = "FILE",
            description = "Draws the room and where the robot went; written at start and when the simulator ends.")
    private @Nullable Path svg;

    @Mixin
    private final CameraArguments camera = new CameraArguments();

    @Mixin
    private final RobotArguments robot = new RobotArguments();

    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it before it calls.
    private CommandSpec spec;

    /** Reads what is typed from standard input. */
    public SimulatorCommand() {
        this(System.in);
    }

    SimulatorCommand(InputStream input) {
        this.input = input;
    }

    @Override
    public Integer call() throws InterruptedException {
        CountDownLatch exit = new CountDownLatch(1);
        CountDownLatch ended = new CountDownLatch(1);
        Thread onSignal = new Thread(() -> endBySignal(exit, ended), "simulator-signal");
        Trail trail = new Trail();
        try (Clock clock = new SystemClock();
                SimulatorServer server = start(clock, trail)) {
            draw(server, trail);
            Runtime.getRuntime().addShutdownHook(onSignal);
            PrintWriter output = spec.commandLine().getOut();
            output.println("ready " + server.path());
            server.camera().ifPresent(webcam -> output.println("camera " + webcam.url()));
            output.flush();
            answerInBackground(new WorldCommands(server), output, exit);
            exit.await();
            draw(server, trail);
        }
        ended.countDown();
        removeHook(onSignal);
        return CommandLine.ExitCode.OK;
    }

    private SimulatorServer start(Clock clock, Trail trail) {
        try {
            return SimulatorServer.start(link, robot.toOptions(), clock, speed, trail, camera.toOptions());
        } catch (IllegalArgumentException | IOException mistake) {
            throw mistake("cannot start the simulator: " + mistake.getMessage());
        }
    }

    private void draw(SimulatorServer server, Trail trail) {
        if (svg == null) {
            return;
        }
        try {
            Files.writeString(svg, drawing(server, trail));
        } catch (IOException failure) {
            throw mistake("cannot write " + svg + " (--svg); its folder must exist and be writable");
        }
    }

    private static String drawing(SimulatorServer server, Trail trail) {
        RobotState state = server.robot().state();
        return server.camera()
                .map(webcam ->
                        RoomDrawing.svg(state, trail, webcam.options().eye().fieldOfViewDeg()))
                .orElseGet(() -> RoomDrawing.svg(state, trail));
    }

    private CommandLine.ParameterException mistake(String message) {
        return new CommandLine.ParameterException(spec.commandLine(), message);
    }

    /** A daemon thread, since nothing but the end of input ends a read. */
    private void answerInBackground(WorldCommands commands, PrintWriter output, CountDownLatch exit) {
        Thread thread = new Thread(() -> answer(commands, output, exit), "simulator-input");
        thread.setDaemon(true);
        thread.start();
    }

    private void answer(WorldCommands commands, PrintWriter output, CountDownLatch exit) {
        try {
            BufferedReader lines = new BufferedReader(new InputStreamReader(input, StandardCharsets.UTF_8));
            for (String line = lines.readLine(); line != null; line = lines.readLine()) {
                boolean isLast = line.trim().equals("exit");
                output.println(isLast ? "ok" : commands.execute(line));
                output.flush();
                if (isLast) {
                    exit.countDown();
                    return;
                }
            }
            if (!keepRunning) {
                exit.countDown();
            }
        } catch (IOException failure) {
            LOG.warn("no more commands are read: {}", failure.getMessage());
        }
    }

    /** A signal is an ordinary way to end; left alone, the JVM would report it as a failure. */
    private static void endBySignal(CountDownLatch exit, CountDownLatch ended) {
        exit.countDown();
        try {
            if (ended.await(END_LIMIT_SECONDS, TimeUnit.SECONDS)) {
                Runtime.getRuntime().halt(CommandLine.ExitCode.OK);
            }
        } catch (InterruptedException stop) {
            Thread.currentThread().interrupt();
        }
    }

    private static void removeHook(Thread hook) {
        try {
            Runtime.getRuntime().removeShutdownHook(hook);
        } catch (IllegalStateException endingAlready) {
            // A signal ended the simulator, and the hook is at work.
        }
    }
}
