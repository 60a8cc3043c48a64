package org.evoloop.roomba.simulator;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Consumer;
import org.evoloop.natives.Pty;
import org.evoloop.roomba.simulator.robot.RobotOptions;
import org.evoloop.roomba.simulator.robot.RobotState;
import org.evoloop.roomba.simulator.robot.SimulatedRoomba;
import org.evoloop.roomba.simulator.webcam.Webcam;
import org.evoloop.roomba.simulator.webcam.WebcamOptions;
import org.evoloop.time.Clock;
import org.evoloop.time.Threads;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A simulated robot at a pseudo-terminal. It runs until it is closed, while clients connect and disconnect.
 *
 * <p>Pace: robot time passes {@code speed} times as fast as the clock. A server that is late catches up tick by
 * tick, and reads bytes from the client between the ticks. A delay beyond {@value #LONGEST_LAG_SECONDS} s of the clock
 * is skipped.
 *
 * <p>A pseudo-terminal has no wake line: a client that opens the port causes a pulse instead. It does not transfer bits
 * either: the robot gets the client's baud rate, and turns bytes at a wrong rate into garbage.
 *
 * <p>Threading: one thread, which waits at the pseudo-terminal until bytes arrive or a tick is due. All methods may be
 * called from any thread.
 *
 * @since 0.1
 */
public final class SimulatorServer implements Cable, AutoCloseable {
    /** The slowest factor of simulated to real time. */
    public static final double SLOWEST = 0.01;
    /** The fastest factor of simulated to real time. */
    public static final double FASTEST = 1000;

    private static final Logger LOG = LoggerFactory.getLogger(SimulatorServer.class);

    private static final long LONGEST_LAG_SECONDS = 1;
    private static final long LONGEST_LAG_NANOS = TimeUnit.SECONDS.toNanos(LONGEST_LAG_SECONDS);
    private static final long NANOS_PER_MILLI = TimeUnit.MILLISECONDS.toNanos(1);
    private static final Duration END_LIMIT = Duration.ofSeconds(2);
    private static final int BUFFER_BYTES = 1_024;

    /** The polling interval while the cable is unplugged. */
    private static final long UNPLUGGED_REST_NANOS = TimeUnit.MILLISECONDS.toNanos(10);

    private final Path link;
    private volatile Pty pty;
    private final SimulatedRoomba robot;
    private final Consumer<RobotState> observer;
    private final @Nullable Webcam camera;
    private final Clock clock;
    private final long nanosPerTick;
    private final long startNanos;
    private final Thread thread = new Thread(this::run, "roomba-simulator");
    private boolean clientPresent;
    private volatile boolean closing;

    private SimulatorServer(
            Path link,
            Pty pty,
            RobotOptions options,
            Clock clock,
            double speed,
            Consumer<RobotState> observer,
            @Nullable Webcam camera) {
        this.link = link;
        this.pty = pty;
        this.robot = new SimulatedRoomba(options, bytes -> this.pty.write(bytes, bytes.length));
        this.observer = observer;
        this.camera = camera;
        this.clock = clock;
        this.startNanos = clock.nanoTime();
        this.nanosPerTick = Math.round(SimulatedRoomba.TICK_MILLIS * NANOS_PER_MILLI / speed);
        thread.setDaemon(true);
    }

    /**
     * Starts a robot; when this returns, clients can open the port.
     *
     * @param link the symbolic link that clients open, see {@link Pty#open(Path)}
     * @param clock stays the caller's
     * @param speed {@value #SLOWEST} to {@value #FASTEST}
     * @throws IOException if there is no pseudo-terminal or no such link to be had
     */
    public static SimulatorServer start(Path link, RobotOptions options, Clock clock, double speed) throws IOException {
        return start(link, options, clock, speed, state -> {});
    }

    /**
     * Starts a robot, as {@link #start(Path, RobotOptions, Clock, double)}, with an observer.
     *
     * @param observer receives the state after every tick, on the server's thread
     */
    public static SimulatorServer start(
            Path link, RobotOptions options, Clock clock, double speed, Consumer<RobotState> observer)
            throws IOException {
        return start(link, options, clock, speed, observer, Optional.empty());
    }

    /**
     * Starts a robot, as {@link #start(Path, RobotOptions, Clock, double, Consumer)}, that carries a camera.
     *
     * @param camera empty for none; when this returns, its clients can connect
     * @throws IOException also if the camera's port cannot be had
     */
    public static SimulatorServer start(
            Path link,
            RobotOptions options,
            Clock clock,
            double speed,
            Consumer<RobotState> observer,
            Optional<WebcamOptions> camera)
            throws IOException {
        if (!(speed >= SLOWEST && speed <= FASTEST)) {
            throw new IllegalArgumentException(
                    "speed is " + speed + "; allowed is " + SLOWEST + " to " + FASTEST + " times real time");
        }
        Webcam webcam = camera.isPresent() ? Webcam.start(camera.get()) : null;
        boolean started = false;
        try {
            SimulatorServer server = new SimulatorServer(link, Pty.open(link), options, clock, speed, observer, webcam);
            server.thread.start();
            started = true;
            return server;
        } finally {
            if (!started && webcam != null) {
                webcam.close();
            }
        }
    }

    private void run() {
        try {
            pace();
        } finally {
            // Should the robot fail, its client sees the cable pulled instead of a robot that is silent for ever.
            pty.hangUp();
        }
    }

    private void pace() {
        byte[] buffer = new byte[BUFFER_BYTES];
        long dueNanos = startNanos + nanosPerTick;
        while (!closing) {
            long nowNanos = clock.nanoTime();
            long waitNanos = dueNanos - nowNanos;
            if (waitNanos < -LONGEST_LAG_NANOS) {
                LOG.warn("the simulator fell {} ms behind; skipping ahead", -waitNanos / NANOS_PER_MILLI);
                dueNanos = nowNanos;
            }
            if (waitNanos <= 0) {
                robot.tick();
                RobotState state = robot.state();
                observer.accept(state);
                if (camera != null) {
                    camera.accept(state);
                }
                dueNanos += nanosPerTick;
            }
            listen(buffer, waitNanos);
        }
    }

    private void listen(byte[] buffer, long waitNanos) {
        Pty cable = pty;
        int earlierBaud = cable.clientBaud();
        int length = cable.read(buffer, waitNanos <= 0 ? 0 : restMillis(waitNanos));
        if (length == Pty.NO_CLIENT) {
            clientPresent = false;
            if (cable.isHungUp()) {
                LockSupport.parkNanos(Math.max(0, Math.min(waitNanos, UNPLUGGED_REST_NANOS)));
            }
            return;
        }
        if (!clientPresent) {
            clientPresent = true;
            robot.wakeUp();
        }
        // A client may change its rate as soon as it has written: its bytes were fine if either rate was.
        robot.clientBaud(earlierBaud == robot.baud() ? earlierBaud : cable.clientBaud());
        if (length > 0) {
            robot.receive(buffer, length);
        }
    }

    /** Never none, or the loop would spin through a tick's last millisecond. */
    private static int restMillis(long waitNanos) {
        return (int) Math.max(1, Math.min(waitNanos / NANOS_PER_MILLI, Pty.LONGEST_WAIT_MILLIS));
    }

    /** The robot behind the port, to inspect it and press its buttons. */
    public SimulatedRoomba robot() {
        return robot;
    }

    /** What the robot sees, for its address and its faults; empty if it carries no camera. */
    public Optional<Webcam> camera() {
        return Optional.ofNullable(camera);
    }

    /** The path that clients open. */
    public Path path() {
        return link;
    }

    @Override
    public synchronized void unplug() {
        if (pty.isHungUp()) {
            throw new IllegalArgumentException("the cable is unplugged already");
        }
        pty.hangUp();
    }

    @Override
    public synchronized void replug() throws IOException {
        if (!pty.isHungUp()) {
            throw new IllegalArgumentException("the cable is plugged in already");
        }
        if (closing) {
            throw new IllegalArgumentException("the simulator has ended");
        }
        pty = Pty.open(link);
    }

    /** Unplugs the cables, removes the link and stops the robot. A second call does nothing. */
    @Override
    public void close() {
        synchronized (this) {
            closing = true;
            pty.hangUp();
        }
        if (camera != null) {
            camera.close();
        }
        if (!Threads.join(thread, END_LIMIT)) {
            LOG.warn("thread {} did not end within {} ms", thread.getName(), END_LIMIT.toMillis());
        }
    }
}
