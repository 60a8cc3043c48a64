package org.evoloop.roomba.simulator;

import java.io.IOException;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import org.evoloop.roomba.simulator.robot.RobotOptions;
import org.evoloop.roomba.simulator.robot.SimulatedRoomba;
import org.evoloop.time.Clock;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A simulated robot at a pseudo-terminal, alive until it is closed. Its clients may come and go; the robot goes on.
 *
 * <p>Pace: robot time passes {@code speed} times as fast as the clock. A server that is late makes up for it tick by
 * tick, and looks for bytes from the client between the ticks; what it is late by more than
 * {@value #LONGEST_LAG_SECONDS} s of the clock is lost to the robot.
 *
 * <p>Threading: one thread, which rests in the pseudo-terminal until bytes come or a tick is due. All methods may be
 * called from any thread.
 */
public final class SimulatorServer implements AutoCloseable {
    public static final double SLOWEST = 0.01;
    public static final double FASTEST = 1000;

    private static final Logger LOG = LoggerFactory.getLogger(SimulatorServer.class);

    private static final long LONGEST_LAG_SECONDS = 1;
    private static final long LONGEST_LAG_NANOS = TimeUnit.SECONDS.toNanos(LONGEST_LAG_SECONDS);
    private static final long NANOS_PER_MILLI = TimeUnit.MILLISECONDS.toNanos(1);
    private static final long END_LIMIT_MILLIS = 2_000;
    private static final int BUFFER_BYTES = 1_024;

    private final Pty pty;
    private final SimulatedRoomba robot;
    private final Clock clock;
    private final long nanosPerTick;
    private final long startNanos;
    private final Thread thread = new Thread(this::run, "roomba-simulator");
    private volatile boolean closing;

    private SimulatorServer(Pty pty, RobotOptions options, Clock clock, double speed) {
        this.pty = pty;
        this.robot = new SimulatedRoomba(options, bytes -> pty.write(bytes, bytes.length));
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
        if (!(speed >= SLOWEST && speed <= FASTEST)) {
            throw new IllegalArgumentException(
                    "speed is " + speed + "; allowed is " + SLOWEST + " to " + FASTEST + " times real time");
        }
        SimulatorServer server = new SimulatorServer(Pty.open(link), options, clock, speed);
        server.thread.start();
        return server;
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
                LOG.warn("the simulator was {} ms late and gives them up", -waitNanos / NANOS_PER_MILLI);
                dueNanos = nowNanos;
            }
            if (waitNanos <= 0) {
                robot.tick();
                dueNanos += nanosPerTick;
            }
            int length = pty.read(buffer, waitNanos <= 0 ? 0 : restMillis(waitNanos));
            if (length > 0) {
                robot.receive(buffer, length);
            }
        }
    }

    /** Never none, or the loop would spin through a tick's last millisecond. */
    private static int restMillis(long waitNanos) {
        return (int) Math.max(1, Math.min(waitNanos / NANOS_PER_MILLI, Pty.LONGEST_WAIT_MILLIS));
    }

    /** The robot behind the port, to look at it and to press its buttons. */
    public SimulatedRoomba robot() {
        return robot;
    }

    /** The file that clients open. */
    public Path path() {
        return pty.path();
    }

    /** Pulls the cable, removes the link and ends the robot. A second call does nothing. */
    @Override
    public void close() {
        closing = true;
        pty.hangUp();
        try {
            thread.join(END_LIMIT_MILLIS);
            if (thread.isAlive()) {
                LOG.warn("thread {} did not end within {} ms", thread.getName(), END_LIMIT_MILLIS);
            }
        } catch (InterruptedException stop) {
            Thread.currentThread().interrupt();
        }
    }
}
