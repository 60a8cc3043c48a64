package org.evoloop.roomba.session;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.ExecutionException;
import java.util.function.IntFunction;
import org.evoloop.converter.DeviceLink;
import org.evoloop.roomba.link.Link;
import org.evoloop.roomba.link.LinkException;
import org.evoloop.roomba.oi.ActuatorCommand;
import org.evoloop.roomba.oi.Command;
import org.evoloop.roomba.oi.Packet;
import org.evoloop.roomba.oi.PacketId;
import org.evoloop.roomba.oi.SensorValues;
import org.evoloop.roomba.oi.StreamFramer;
import org.evoloop.roomba.session.connection.Connection;
import org.evoloop.roomba.session.connection.RobotException;
import org.evoloop.roomba.session.inference.FrameFilter;
import org.evoloop.roomba.session.inference.ModeOffset;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A conversation with a Roomba: one stream of sensor values, which is the session's only source, and commands. It outlives
 * a cable that is pulled and plugged in again, and a robot that sleeps.
 *
 * <p>Lifecycle: {@link #open}, then {@link #awaitRobot}; {@link #close} stops a robot under control and leaves it in
 * Passive mode; one that works by itself goes on.
 *
 * <p>Threading: all methods may be called from any thread. Listeners are called on the link's thread.
 */
public final class RoombaSession implements DeviceLink, AutoCloseable {
    /**
     * All that is looked at and nothing else, 38 bytes a frame: the shorter, the more frames pass a noisy line. Fits 57600
     * baud and above.
     */
    public static final List<PacketId> STREAM = List.of(
            Packet.BUMPS_AND_WHEEL_DROPS,
            Packet.CLIFF_LEFT,
            Packet.CLIFF_FRONT_LEFT,
            Packet.CLIFF_FRONT_RIGHT,
            Packet.CLIFF_RIGHT,
            Packet.VIRTUAL_WALL,
            Packet.BUTTONS,
            Packet.CURRENT,
            Packet.CHARGING_SOURCES,
            Packet.OI_MODE,
            Packet.LEFT_ENCODER,
            Packet.RIGHT_ENCODER,
            Packet.LIGHT_BUMPER,
            Packet.MAIN_BRUSH_CURRENT,
            Packet.SIDE_BRUSH_CURRENT);

    private static final Logger LOG = LoggerFactory.getLogger(RoombaSession.class);

    /** So many frames whose checksum is wrong, and none whose is right, are no chance. */
    private static final int TELLING_FRAMES = 20;

    private final Clock clock;
    private final SessionOptions options;
    private final Connection connection;
    private final Listeners listeners = new Listeners();
    private final Object receiving = new Object();
    private final Object sending = new Object();
    private final StreamFramer framer = new StreamFramer(STREAM, this::framed);
    private final ModeOffset modeOffset;
    private final FrameFilter filter;
    private final Odometry odometry = new Odometry();
    private final RobotWatch watch = new RobotWatch(listeners);
    private final Control control;
    private boolean modeChanged;
    private long modeChangedNanos;
    private volatile @Nullable Telemetry latest;

    /**
     * @param cable makes a new link to the robot at a baud rate; called again whenever the link was lost
     */
    public RoombaSession(IntFunction<Link> cable, Clock clock, SessionOptions options) {
        this.clock = clock;
        this.options = options;
        this.modeOffset = new ModeOffset(options.modeOffset());
        this.filter = new FrameFilter(modeOffset);
        Connection.Options wanted = new Connection.Options(STREAM, options.silenceLimit(), options.mayWait());
        this.connection = new Connection(cable, clock, wanted, new Connection.Owner() {
            @Override
            public void received(byte[] buffer, int length) {
                synchronized (receiving) {
                    framer.feed(buffer, 0, length);
                }
            }

            @Override
            public void outOfSight() {
                synchronized (receiving) {
                    control.loseSight();
                    watch.forget();
                }
            }

            @Override
            public String frameTrouble() {
                synchronized (receiving) {
                    return RoombaSession.frameTrouble(framer);
                }
            }

            @Override
            public boolean isDozing() {
                synchronized (receiving) {
                    return !isUnderControl() && watch.isAtRest();
                }
            }
        });
        this.control = new Control(connection, watch);
    }

    /** Adds a listener; it hears all that comes from now on. */
    public void addListener(SessionListener listener) {
        listeners.add(listener);
    }

    /** Removes a listener. */
    public void removeListener(SessionListener listener) {
        listeners.remove(listener);
    }

    /**
     * Opens the link and asks the robot for its stream; does not wait for an answer.
     *
     * @throws LinkException if the link cannot be opened
     */
    public void open() {
        connection.open();
    }

    /**
     * Waits for the robot to answer; it is woken if it does not.
     *
     * @throws RobotException if it stays silent
     * @throws LinkException if the link is lost meanwhile, or the session closed
     * @throws InterruptedException if the thread is told to stop while it waits
     */
    public void awaitRobot() throws InterruptedException {
        try {
            connection.firstAnswer().get();
        } catch (ExecutionException failure) {
            if (failure.getCause() instanceof RuntimeException cause) {
                throw cause;
            }
            throw new IllegalStateException(failure);
        }
    }

    /** Frames that fit in everything but their checksum are no matter of the baud rate. */
    private static String frameTrouble(StreamFramer framer) {
        if (framer.frames() > 0 || framer.badChecksums() < TELLING_FRAMES) {
            return "";
        }
        return 2 * framer.headerlessChecksums() > framer.badChecksums()
                ? "frames come, but their checksum leaves out the header byte, as the Roomba 500's specification has it and "
                        + "no robot is known to do. A simulated robot does with --checksum spec500: start it without"
                : "frames come, but their checksum never fits: the cable or its adapter changes bytes. Try another one";
    }

    /** One frame has come; called on the link's thread. */
    private void framed(SensorValues raw) {
        learnModeOffset(raw.value(Packet.OI_MODE));
        if (!modeOffset.isKnown()) {
            return;
        }
        SensorValues values = filter.filter(raw);
        Telemetry earlier = latest;
        Telemetry now = new Telemetry(earlier == null ? 1 : earlier.frame() + 1, values, odometry.update(values));
        latest = now;
        // Who waits for the robot finds its values.
        connection.answered();
        listeners.received(now);
        control.update(now);
        watch.update(now, !control.isWanted());
    }

    private void learnModeOffset(int reported) {
        int before = modeOffset.value();
        if (modeOffset.update(reported)) {
            connection.trySend(new Command.Start());
        }
        if (modeOffset.value() != before) {
            LOG.warn(
                    "{}: the robot reports its mode {}; modes are read accordingly",
                    connection.description(),
                    modeOffset.value() == 1 ? "one too high, as some 600 models do" : "as specified");
        }
    }

    /**
     * Sends a command, once the robot has digested the last one that changed its mode. An interrupt makes it go at once
     * instead of not at all: what stops the wheels is sent by threads that are being stopped.
     *
     * @throws LinkException if it could not be sent
     * @throws RobotException if the robot has just come back into sight and is not under control again yet
     */
    public void send(Command command) {
        if (control.isRegaining()) {
            throw new RobotException(connection.description()
                    + ": the robot has just come back into sight; try again when it is under control");
        }
        synchronized (sending) {
            if (options.mayWait()) {
                pauseAfterModeChange();
            }
            connection.send(command.bytes());
            if (command.opcode().changesMode()) {
                modeChanged = true;
                modeChangedNanos = clock.nanoTime();
            }
        }
        synchronized (receiving) {
            control.commanded(command);
            watch.commanded(command);
        }
    }

    private void pauseAfterModeChange() {
        long leftNanos = Connection.MODE_CHANGE.toNanos() - (clock.nanoTime() - modeChangedNanos);
        if (modeChanged && leftNanos > 0) {
            try {
                clock.sleep(Duration.ofNanos(leftNanos));
            } catch (InterruptedException hurry) {
                Thread.currentThread().interrupt();
            }
        }
    }

    /**
     * Puts the robot under control now, and again whenever it has left Safe mode by itself and is at rest; what it does by
     * itself without being asked is ended.
     *
     * @throws LinkException if the command could not be sent
     */
    public void takeControl() {
        synchronized (receiving) {
            control.want();
        }
        if (!isUnderControl()) {
            send(new Command.Safe());
        }
    }

    /** Leaves the robot to itself for now; if it comes back from out of sight, control is taken. */
    public void leaveAlone() {
        synchronized (receiving) {
            control.leaveAlone();
        }
    }

    /** Stops the wheels if the robot is under control or about to be, and gives it back to itself for good. */
    public void letGo() {
        boolean mayHaveControl;
        synchronized (receiving) {
            // Control that was just asked for may show only in the next frame.
            mayHaveControl = control.isWanted() || control.isRegaining() || isUnderControl();
            control.letGo();
        }
        if (mayHaveControl) {
            send(new ActuatorCommand.DriveDirect(0, 0));
            send(new Command.Start());
        }
    }

    /** What the last frame told; null before the first. */
    public @Nullable Telemetry latest() {
        return latest;
    }

    /** Whether the robot obeys drive commands, as of the last frame. */
    public boolean isUnderControl() {
        Telemetry now = latest;
        return now != null && now.isUnderControl();
    }

    /** Whether commands can be waited for; false if time only passes when the caller lets it. */
    public boolean mayWait() {
        return options.mayWait();
    }

    @Override
    public boolean isUp() {
        return connection.isUp();
    }

    @Override
    public Optional<Instant> downSince() {
        return connection.downSince();
    }

    /** Port, trouble or mode, and how many frames were good and bad. */
    @Override
    public String describe() {
        Telemetry now = latest;
        String trouble = connection.trouble();
        if (!trouble.isEmpty() || now == null) {
            return connection.description() + ": " + trouble;
        }
        String mode = now.values()
                .mode()
                .map(known -> known.name().toLowerCase(Locale.ROOT))
                .orElse("unknown");
        synchronized (receiving) {
            return connection.description() + ", mode " + mode
                    + (modeOffset.value() == 0 ? "" : " (reported one too high)") + ", " + framer.frames() + " frames, "
                    + framer.badChecksums() + " bad, " + framer.skippedBytes() + " bytes skipped";
        }
    }

    /** Lets go of the robot as {@link #letGo()} does, and closes the link. Idempotent. */
    @Override
    public void close() {
        try {
            letGo();
        } catch (LinkException gone) {
            LOG.debug("{}", gone.getMessage());
        }
        connection.close();
    }
}
