package org.evoloop.roomba.session;

import java.time.Duration;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.Semaphore;
import org.evoloop.converter.DeviceLink;
import org.evoloop.roomba.link.Link;
import org.evoloop.roomba.link.LinkException;
import org.evoloop.roomba.oi.ActuatorCommand;
import org.evoloop.roomba.oi.Button;
import org.evoloop.roomba.oi.Command;
import org.evoloop.roomba.oi.InputCommand;
import org.evoloop.roomba.oi.Packet;
import org.evoloop.roomba.oi.PacketId;
import org.evoloop.roomba.oi.SensorValues;
import org.evoloop.roomba.oi.StreamFramer;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A conversation with a Roomba: one stream of sensor values, which is the session's only source, and commands.
 *
 * <p>Lifecycle: {@link #open}, then {@link #awaitRobot}; {@link #close} leaves the robot stopped and in Passive mode.
 *
 * <p>Threading: all methods may be called from any thread. Listeners are called on the link's thread.
 */
public final class RoombaSession implements DeviceLink, AutoCloseable {
    /** All that is looked at, 44 bytes a frame: fits 57600 baud and above. */
    static final List<PacketId> STREAM = List.of(
            Packet.BUMPS_AND_WHEEL_DROPS,
            Packet.CLIFF_LEFT,
            Packet.CLIFF_FRONT_LEFT,
            Packet.CLIFF_FRONT_RIGHT,
            Packet.CLIFF_RIGHT,
            Packet.OVERCURRENTS,
            Packet.BUTTONS,
            Packet.CHARGING_STATE,
            Packet.CURRENT,
            Packet.CHARGING_SOURCES,
            Packet.OI_MODE,
            Packet.LEFT_ENCODER,
            Packet.RIGHT_ENCODER,
            Packet.LEFT_MOTOR_CURRENT,
            Packet.RIGHT_MOTOR_CURRENT,
            Packet.MAIN_BRUSH_CURRENT,
            Packet.SIDE_BRUSH_CURRENT);

    /** Field code leaves this much between commands that change the mode. */
    static final Duration MODE_CHANGE = Duration.ofMillis(20);

    private static final Logger LOG = LoggerFactory.getLogger(RoombaSession.class);
    private static final int ATTEMPTS = 3;
    private static final Duration ANSWER_LIMIT = Duration.ofSeconds(1);
    private static final Duration WAKE_PULSE = Duration.ofMillis(500);

    private final Link link;
    private final Clock clock;
    private final boolean mayWait;
    private final List<SessionListener> listeners = new CopyOnWriteArrayList<>();
    private final Semaphore news = new Semaphore(0);
    private final Object receiving = new Object();
    private final Object sending = new Object();
    private final StreamFramer framer = new StreamFramer(STREAM, this::framed);
    private final ButtonPresses buttons = new ButtonPresses();
    private final Odometry odometry = new Odometry();
    private final SpotWatch spotWatch = new SpotWatch();
    private boolean modeChanged;
    private long modeChangedNanos;
    private volatile @Nullable Telemetry latest;
    private volatile @Nullable LinkException lost;

    /**
     * @param link a new link to the robot, which the session opens and closes
     * @param mayWait false if time only passes when the caller lets it: then no command waits for its moment
     */
    public RoombaSession(Link link, Clock clock, boolean mayWait) {
        this.link = link;
        this.clock = clock;
        this.mayWait = mayWait;
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
        link.open(new Link.Receiver() {
            @Override
            public void received(byte[] buffer, int length) {
                synchronized (receiving) {
                    framer.feed(buffer, 0, length);
                }
            }

            @Override
            public void lost(LinkException cause) {
                lost = cause;
                LOG.warn("{}", cause.getMessage());
            }
        });
        ask();
    }

    private void ask() {
        send(new Command.Start());
        send(new InputCommand.Stream(STREAM));
    }

    /**
     * Waits for the robot to answer, and wakes it if it does not.
     *
     * @throws RobotException if it stays silent
     * @throws InterruptedException if the thread is told to stop while it waits
     */
    public void awaitRobot() throws InterruptedException {
        for (int attempt = 1; !answers(); attempt++) {
            if (attempt == ATTEMPTS) {
                throw new RobotException(
                        link.description() + ": the robot does not answer. Is it switched on and awake "
                                + "(press CLEAN), is its cable plugged in, and is this the port that the cable is on?");
            }
            // One long pulse: three short ones would switch the robot to 19200 baud.
            link.wakeLine().setLow(true);
            clock.sleep(WAKE_PULSE);
            link.wakeLine().setLow(false);
            clock.sleep(MODE_CHANGE);
            ask();
        }
    }

    private boolean answers() throws InterruptedException {
        Clock.Timer limit = clock.schedule(ANSWER_LIMIT, news::release);
        news.acquire();
        limit.cancel();
        return latest != null;
    }

    /** One frame has come; called on the link's thread. */
    private void framed(SensorValues values) {
        Telemetry earlier = latest;
        Telemetry now = new Telemetry(earlier == null ? 1 : earlier.frame() + 1, values, odometry.update(values));
        latest = now;
        if (earlier == null) {
            news.release();
        }
        listeners.forEach(listener -> listener.received(now));
        for (Button button : buttons.update(values.buttons())) {
            boolean robotActs = !now.isUnderControl();
            if (button == Button.SPOT && robotActs && !spotWatch.isRobotActive()) {
                spotWatch.started();
            }
            listeners.forEach(listener -> listener.pressed(button, robotActs));
        }
        SpotWatch.Ending ending = spotWatch.update(values);
        if (ending != null) {
            listeners.forEach(listener -> listener.spotEnded(ending));
        }
    }

    /**
     * Sends a command, once the robot has digested the last one that changed its mode. An interrupt makes it go at once
     * instead of not at all: what stops the wheels is sent by threads that are being stopped.
     *
     * @throws LinkException if it could not be sent
     */
    public void send(Command command) {
        synchronized (sending) {
            if (mayWait) {
                pauseAfterModeChange();
            }
            link.send(command.bytes());
            if (command.opcode().changesMode()) {
                modeChanged = true;
                modeChangedNanos = clock.nanoTime();
            }
        }
        if (command instanceof Command.Spot) {
            synchronized (receiving) {
                spotWatch.started();
            }
        }
    }

    private void pauseAfterModeChange() {
        long leftNanos = MODE_CHANGE.toNanos() - (clock.nanoTime() - modeChangedNanos);
        if (modeChanged && leftNanos > 0) {
            try {
                clock.sleep(Duration.ofNanos(leftNanos));
            } catch (InterruptedException hurry) {
                Thread.currentThread().interrupt();
            }
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
        return mayWait;
    }

    @Override
    public boolean isUp() {
        return lost == null && latest != null;
    }

    @Override
    public String describe() {
        LinkException cause = lost;
        Telemetry now = latest;
        if (cause != null) {
            return String.valueOf(cause.getMessage());
        }
        if (now == null) {
            return link.description() + ", no answer yet";
        }
        String mode = now.values()
                .mode()
                .map(known -> known.name().toLowerCase(Locale.ROOT))
                .orElse("unknown");
        synchronized (receiving) {
            return link.description() + ", mode " + mode + ", " + framer.frames() + " frames, " + framer.badChecksums()
                    + " bad, " + framer.skippedBytes() + " bytes skipped";
        }
    }

    /** Stops the wheels and gives the robot back to itself, if it is under control. */
    public void letGo() {
        if (isUnderControl()) {
            send(new ActuatorCommand.DriveDirect(0, 0));
            send(new Command.Start());
        }
    }

    /** Leaves the robot stopped and in Passive mode, and closes the link. Idempotent. */
    @Override
    public void close() {
        try {
            if (lost == null) {
                letGo();
            }
        } catch (LinkException gone) {
            LOG.warn("the robot could not be stopped: {}", gone.getMessage());
        }
        link.close();
    }
}
