package org.evoloop.roomba.testkit;

import static java.util.Objects.requireNonNull;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import org.evoloop.roomba.oi.Button;
import org.evoloop.roomba.simulator.SimulatorServer;
import org.evoloop.roomba.simulator.robot.RobotOptions;
import org.evoloop.roomba.simulator.robot.RobotState;
import org.evoloop.roomba.simulator.robot.SimulatedRoomba;
import org.evoloop.time.SystemClock;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.extension.AfterEachCallback;
import org.junit.jupiter.api.extension.BeforeEachCallback;
import org.junit.jupiter.api.extension.ExtensionContext;

/**
 * Gives each test a simulated Roomba on its own serial port, which any program can open, and closes it
 * afterwards.
 *
 * <pre>{@code
 * @RegisterExtension
 * final SimulatedRoombaExtension roomba = SimulatedRoombaExtension.create().speed(20);
 *
 * @Test
 * void itCleansWhenItIsTold() throws Exception {
 *     roomba.press(Button.CLEAN); // switches it on
 *     roomba.until(robot -> robot.activity() == RobotActivity.ON);
 *     try (Link driver = SerialLink.open(new SerialSettings(roomba.port().toString()))) {
 *         driver.send(new Command.Start().bytes());
 *         driver.send(new Command.Clean().bytes());
 *         roomba.until(robot -> robot.activity() == RobotActivity.CLEAN);
 *     }
 * }
 * }</pre>
 *
 * <p>Errors: a condition that does not hold in time is an {@link AssertionError} with the robot's last state.
 *
 * <p>Threading: the robot has a thread of its own; all methods may be called from any thread. One object serves one
 * test at a time.
 * @since 0.1
 */
public final class SimulatedRoombaExtension implements BeforeEachCallback, AfterEachCallback {
    private static final String PORT = "roomba";

    private final Object lock = new Object();
    private RobotOptions options = RobotOptions.defaults();
    private double speed = 1;
    private Duration patience = Duration.ofSeconds(20);
    private @Nullable Path folder;
    private @Nullable SystemClock clock;
    private @Nullable SimulatorServer server;
    private @Nullable RobotState last;

    private SimulatedRoombaExtension() {}

    /** A robot with {@link RobotOptions#defaults}, in real time. */
    public static SimulatedRoombaExtension create() {
        return new SimulatedRoombaExtension();
    }

    /**
     * Sets the robot's options, such as its room, its battery and the noise on its line. Applies from the next test on.
     */
    public SimulatedRoombaExtension options(RobotOptions itsOptions) {
        options = requireNonNull(itsOptions, "the robot's options are null");
        return this;
    }

    /**
     * Sets the speed of the robot's time relative to real time.
     *
     * @param factor {@value SimulatorServer#SLOWEST} to {@value SimulatorServer#FASTEST}
     */
    public SimulatedRoombaExtension speed(double factor) {
        speed = factor;
        return this;
    }

    /** Sets how long {@link #until} waits at most, in real time; 20 s by default. */
    public SimulatedRoombaExtension patience(Duration longest) {
        patience = requireNonNull(longest, "the patience is null");
        return this;
    }

    @Override
    public void beforeEach(ExtensionContext context) throws IOException {
        Path own = Files.createTempDirectory("evoloop-roomba-");
        SystemClock its = new SystemClock();
        folder = own;
        clock = its;
        last = null;
        boolean started = false;
        try {
            server = SimulatorServer.start(own.resolve(PORT), options, its, speed, this::seen);
            started = true;
        } finally {
            if (!started) {
                end();
            }
        }
    }

    @Override
    public void afterEach(ExtensionContext context) throws IOException {
        end();
    }

    private void end() throws IOException {
        if (server != null) {
            server.close();
            server = null;
        }
        if (clock != null) {
            clock.close();
            clock = null;
        }
        if (folder != null) {
            Files.deleteIfExists(folder.resolve(PORT));
            Files.delete(folder);
            folder = null;
        }
    }

    private void seen(RobotState state) {
        synchronized (lock) {
            last = state;
            lock.notifyAll();
        }
    }

    private SimulatorServer server() {
        SimulatorServer running = server;
        if (running == null) {
            throw new IllegalStateException(
                    "there is a robot only while a test runs; register this by @RegisterExtension, in a field");
        }
        return running;
    }

    /** The file that a program opens as the robot's serial port. */
    public Path port() {
        return server().path();
    }

    /** The simulated robot: to press and hold its buttons, to lift, place and dock it. */
    public SimulatedRoomba robot() {
        return server().robot();
    }

    /** Presses one of its buttons briefly. */
    public void press(Button button) {
        robot().press(button);
    }

    /** The robot's current true state. */
    public RobotState state() {
        return robot().state();
    }

    /**
     * Pulls the cable; the port disappears.
     *
     * @throws IllegalArgumentException if it is pulled already
     */
    public void unplug() {
        server().unplug();
    }

    /**
     * Plugs the cable in again.
     *
     * @throws IOException if no port is available
     */
    public void replug() throws IOException {
        server().replug();
    }

    /**
     * Waits until {@code wanted} holds; checked after each tick of 15 ms of the robot's time.
     *
     * @return the state in which it held
     * @throws AssertionError if it does not hold in time; the message contains the last state
     */
    public RobotState until(Predicate<RobotState> wanted) throws InterruptedException {
        server();
        long deadline = System.nanoTime() + patience.toNanos();
        synchronized (lock) {
            RobotState now = last;
            while (now == null || !wanted.test(now)) {
                long left = deadline - System.nanoTime();
                if (left <= 0) {
                    throw new AssertionError("the robot did not reach the wanted state within " + patience + "; it is "
                            + (now == null ? "not there" : now.toJson()));
                }
                TimeUnit.NANOSECONDS.timedWait(lock, left);
                now = last;
            }
            return now;
        }
    }
}
