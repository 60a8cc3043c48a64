package org.evoloop.roomba.session;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.ExecutionException;
import java.util.function.BooleanSupplier;
import java.util.function.IntFunction;
import org.evoloop.converter.DeviceLink;
import org.evoloop.function.Reading;
import org.evoloop.link.Link;
import org.evoloop.link.LinkException;
import org.evoloop.roomba.oi.ActuatorCommand;
import org.evoloop.roomba.oi.Command;
import org.evoloop.roomba.oi.Packet;
import org.evoloop.roomba.oi.PacketId;
import org.evoloop.roomba.session.connection.RobotConnection;
import org.evoloop.roomba.session.connection.RobotException;
import org.evoloop.roomba.session.inference.ActivityEstimate;
import org.evoloop.roomba.session.inference.Circumstances;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A session with a Roomba: one stream of sensor values, which is the session's only source, and commands. It survives a
 * cable that is unplugged and plugged in again, and a robot that sleeps.
 *
 * <p>Lifecycle: {@link #open}, then {@link #awaitRobot}; {@link #close} stops a robot under control and leaves it in
 * Passive mode; one that works by itself continues.
 *
 * <p>Threading: all methods may be called from any thread. Listeners are called on the thread that reads from the link,
 * or on the one that {@link #poll polls}.
 *
 * @since 0.1
 */
public final class RoombaSession implements DeviceLink, AutoCloseable {
    /**
     * Only the packets that are used, 48 bytes per frame: the shorter, the more frames survive a noisy line. Fits 57600
     * baud and above.
     */
    public static final List<PacketId> STREAM = List.of(
            Packet.BUMPS_AND_WHEEL_DROPS,
            Packet.CLIFF_LEFT,
            Packet.CLIFF_FRONT_LEFT,
            Packet.CLIFF_FRONT_RIGHT,
            Packet.CLIFF_RIGHT,
            Packet.VIRTUAL_WALL,
            Packet.OVERCURRENTS,
            Packet.BUTTONS,
            Packet.CHARGING_STATE,
            Packet.CURRENT,
            Packet.BATTERY_CHARGE,
            Packet.BATTERY_CAPACITY,
            Packet.CHARGING_SOURCES,
            Packet.OI_MODE,
            Packet.LEFT_ENCODER,
            Packet.RIGHT_ENCODER,
            Packet.LIGHT_BUMPER,
            Packet.MAIN_BRUSH_CURRENT,
            Packet.SIDE_BRUSH_CURRENT);

    private static final Logger LOG = LoggerFactory.getLogger(RoombaSession.class);

    private static final Duration EFFECT_LIMIT = Duration.ofMillis(500);

    /** A robot that starts to work shows it within 3 s, and one at rest is recognised after 1 s. */
    private static final Duration ACTIVITY_LIMIT = Duration.ofMillis(4_500);

    /** A wake pulse, the boot text, at most two requests, and control. */
    private static final Duration WAKE_LIMIT = Duration.ofSeconds(10);

    /** The limits of two requests, and a wake pulse between them. */
    private static final Duration SOON = Duration.ofSeconds(4);

    private static final Duration UNDOCK_LIMIT = Duration.ofSeconds(12);

    /** The polling interval while waiting for the robot to show something: three times per frame. */
    private static final Duration LOOK = Duration.ofMillis(5);

    private final Clock clock;
    private final SessionOptions options;
    private final RobotReader reader;
    private final RobotConnection connection;
    private final Control control;
    private final Object sending = new Object();
    private volatile boolean waking;
    private boolean modeChanged;
    private long modeChangedNanos;

    /**
     * @param cable opens a new link to the robot at a baud rate; called again whenever the link was lost
     */
    public RoombaSession(IntFunction<Link> cable, Clock clock, SessionOptions options) {
        this.clock = clock;
        this.options = options;
        this.reader = new RobotReader(cable, clock, options);
        this.connection = reader.connection();
        this.control = reader.control();
    }

    /** Adds a listener, which is notified from now on. */
    public void addListener(SessionListener listener) {
        reader.addListener(listener);
    }

    /** Removes a listener. */
    public void removeListener(SessionListener listener) {
        reader.removeListener(listener);
    }

    /**
     * Sets what the robot was doing when the previous process last saw it, before {@link #open}: its motors show
     * whether it still does, and listeners are notified if not.
     */
    public void assume(ActivityEstimate.EstimatedActivity last) {
        reader.assume(last);
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
     * As {@link #open}, for a robot or link that may come later: the session waits for both as after a loss, and {@link
     * #describe} says so. Returns when the robot has answered, as one that is connected and awake does soon, or when
     * the session has begun to wait for it.
     *
     * @param greeting the commands sent to the robot when it first answers
     * @throws LinkException if the path exists but is not a port, or this user has no permission
     * @throws InterruptedException if the thread is interrupted while it waits
     */
    public void openPatiently(List<Command> greeting) throws InterruptedException {
        connection.openPatiently(() -> greeting.forEach(connection::trySend));
        await(() -> connection.isUp() || connection.isDown(), SOON);
    }

    /**
     * Waits for the robot to answer; it is woken if it does not.
     *
     * @throws RobotException if it stays silent
     * @throws LinkException if the link is lost meanwhile, or the session closed
     * @throws InterruptedException if the thread is interrupted while it waits
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

    /** Reads what has arrived, if the caller controls the time; else a thread does that. */
    public void poll() {
        connection.poll();
    }

    /**
     * Sends a command, once the robot has processed the last one that changed its mode. An interrupt makes it send at
     * once instead of not at all: threads that are being stopped must be able to stop the wheels.
     *
     * @throws LinkException if it could not be sent
     * @throws RobotException if the robot is silent, so that it may be doing anything, or has just come back into sight
     *     and is not under control again yet
     */
    public void send(Command command) {
        if (isSilent()) {
            throw new RobotException(connection.description() + ": " + connection.trouble());
        }
        if (control.isRegaining()) {
            throw new RobotException(
                    connection.description() + ": the robot has just reconnected; try again when it is under control");
        }
        transmit(command);
    }

    /** Whether the robot does not send, or not yet, though there is a link to it, for example while it is asleep. */
    public boolean isSilent() {
        return connection.hasLink() && !connection.isUp() && !connection.isDown();
    }

    private void transmit(Command command) {
        reader.sending(command);
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
        reader.commanded(command);
    }

    /**
     * Waits until the robot's mode shows that the last command has had its effect; by then listeners have been
     * notified. Returns at once if the mode cannot show the effect, and after a quarter of a second of frames, or half
     * a second without frames, if it has not shown it.
     *
     * @return false if the robot became unreachable before that, so that the effect is unknown
     * @throws InterruptedException if the thread is interrupted while it waits
     */
    public boolean awaitEffect() throws InterruptedException {
        awaitUntil(() -> !reader.isEffectAwaited(), EFFECT_LIMIT);
        return connection.isUp() || !reader.isEffectAwaited();
    }

    /**
     * Waits until the robot's frames show with certainty what it does: whether it is under control, or else its motors.
     *
     * @return empty if that cannot be determined, for example while it is unreachable; after at most four and a half
     *     seconds
     * @throws InterruptedException if the thread is interrupted while it waits
     */
    public Optional<ActivityEstimate.EstimatedActivity> awaitActivity() throws InterruptedException {
        Telemetry last = reader.latest();
        // The next frame may have been sent before this call; without waiting, none is on its way.
        long since = last == null || !options.mayWait() ? 0 : last.frame() + 1;
        awaitUntil(() -> reader.known(since) != null, ACTIVITY_LIMIT);
        return connection.isUp() ? Optional.ofNullable(reader.known(since)) : Optional.empty();
    }

    /** The robot's circumstances, as of the last frames. */
    public Circumstances circumstances() {
        return reader.circumstances();
    }

    private void awaitUntil(BooleanSupplier holds, Duration limit) throws InterruptedException {
        await(() -> !connection.isUp() || holds.getAsBoolean(), limit);
    }

    private void await(BooleanSupplier holds, Duration limit) throws InterruptedException {
        long deadline = clock.nanoTime() + limit.toNanos();
        while (options.mayWait() && !holds.getAsBoolean() && clock.nanoTime() - deadline < 0) {
            clock.sleep(LOOK);
        }
    }

    private void pauseAfterModeChange() {
        long leftNanos = RobotConnection.MODE_CHANGE.toNanos() - (clock.nanoTime() - modeChangedNanos);
        if (modeChanged && leftNanos > 0) {
            try {
                clock.sleep(Duration.ofNanos(leftNanos));
            } catch (InterruptedException hurry) {
                Thread.currentThread().interrupt();
            }
        }
    }

    /**
     * Puts the robot under control now, and again whenever it has left Safe mode by itself and is at rest; anything
     * that it does by itself unasked is ended. A robot that is silent is put under control when it is back.
     *
     * @throws LinkException if the command could not be sent
     */
    public void takeControl() {
        boolean comes;
        synchronized (reader) {
            control.want();
            comes = isUnderControl() || control.isRegaining() || isSilent() || reader.isUndocking();
        }
        connection.letSleep(false);
        if (!comes) {
            send(new Command.Safe());
        }
    }

    /** Leaves the robot to itself for now; if it becomes reachable again, control is taken. */
    public void leaveAlone() {
        synchronized (reader) {
            control.leaveAlone();
        }
    }

    /**
     * Leaves the robot in its normal state: in Passive mode, where its buttons act and it falls asleep after
     * five minutes.
     *
     * @throws LinkException if the command could not be sent
     */
    public void rest() {
        leaveAlone();
        connection.letSleep(true);
        if (isUnderControl()) {
            send(new Command.Start());
        }
    }

    /** Sets whether an unused robot may fall asleep from now on; at first it is kept awake. */
    public void letSleep(boolean may) {
        connection.letSleep(may);
    }

    /** Whether the robot was allowed to fall asleep, and has done so. */
    public boolean isAsleep() {
        return connection.isAsleep();
    }

    /**
     * Wakes a robot that sleeps, and puts it under control. Without waiting, that comes later.
     *
     * @throws RobotException if it does not wake within ten seconds
     * @throws InterruptedException if the thread is interrupted while it waits
     */
    public void wake() throws InterruptedException {
        synchronized (reader) {
            control.want();
        }
        waking = options.mayWait();
        try {
            connection.wake();
            await(this::isUnderControl, WAKE_LIMIT);
        } finally {
            waking = false;
        }
        if (options.mayWait() && !isUnderControl()) {
            reportSoon();
            throw new RobotException(connection.description()
                    + ": the robot sleeps, and its wake line does not wake it. Press CLEAN on it");
        }
    }

    /**
     * Drives the robot backwards off its dock, 0.3 m, and keeps it under control there, unless somebody else moves it
     * meanwhile: its own buttons or another command. Without waiting, it drives as frames come.
     *
     * @return false if the robot became unreachable meanwhile, so that it is unknown where it is
     * @throws LinkException if the robot cannot be reached
     * @throws RobotException if it stays on its dock, is silent, or has just come back into sight
     * @throws InterruptedException if the thread is interrupted while it waits; the robot is stopped
     */
    public boolean leaveDock() throws InterruptedException {
        send(new Command.Full());
        reader.beginUndocking();
        try {
            await(() -> !reader.isUndocking(), UNDOCK_LIMIT);
        } finally {
            if (options.mayWait()) {
                reader.endUndocking();
            }
        }
        if (!connection.isUp()) {
            return false;
        }
        Telemetry now = reader.latest();
        if (options.mayWait() && (now == null || now.values().onHomeBase())) {
            throw new RobotException(
                    connection.description() + ": the robot does not leave its dock; clear the way behind it");
        }
        return true;
    }

    /** Whether a caller waits for the robot to wake, so that its waking is not news. */
    public boolean isWaking() {
        return waking;
    }

    /** Whether the robot is driving off its dock, so that nothing else may drive it. */
    public boolean isUndocking() {
        return reader.isUndocking();
    }

    /**
     * Stops the wheels if the robot is under control or about to be, and gives it back to itself for good. Commands
     * are sent to a silent robot, too: it may still hear them.
     *
     * @throws LinkException if the commands could not be sent
     */
    public void release() {
        boolean mayHaveControl;
        synchronized (reader) {
            mayHaveControl = mayBeUnderControl();
            control.release();
        }
        if (mayHaveControl) {
            transmit(new ActuatorCommand.DriveDirect(0, 0));
            transmit(new Command.Start());
        }
    }

    /**
     * Reports the robot's activity to listeners within a quarter of a second, unless it gets a command first. For
     * listeners that have just reported an event and need its confirmation.
     */
    public void reportSoon() {
        reader.reportSoon();
    }

    /**
     * Reports the robot's circumstances to listeners again, with the next frame; see {@link SessionListener#changed}.
     */
    public void reportAgain() {
        reader.reportAgain();
    }

    /**
     * The robot's readings, see {@link RobotReadings}; none while it cannot be reached. For a sleeping robot, the last
     * ones.
     */
    @Override
    public List<Reading> readings() {
        Telemetry now = reader.latest();
        return now == null || !isUp() ? List.of() : RobotReadings.of(now.values(), isAsleep());
    }

    /** The telemetry of the last frame; null before the first. */
    public @Nullable Telemetry latest() {
        return reader.latest();
    }

    /** Whether the robot obeys drive commands, as of the last frame. */
    public boolean isUnderControl() {
        Telemetry now = reader.latest();
        return now != null && now.isUnderControl();
    }

    /** Whether the robot obeys drive commands or is about to; waits while a frame is being looked at. */
    public boolean mayBeUnderControl() {
        synchronized (reader) {
            // Control that was just requested may show only in the next frame.
            return control.isWanted() || control.isRegaining() || reader.isUndocking() || isUnderControl();
        }
    }

    /**
     * The robot was stopped and its control ended from outside: notifies listeners, see {@link
     * SessionListener#stopped}.
     *
     * @param why for people
     */
    public void stoppedByOthers(String why) {
        reader.stoppedByOthers(why);
    }

    /** Whether commands can be waited for; false if time only passes when the caller lets it. */
    public boolean mayWait() {
        return options.mayWait();
    }

    @Override
    public boolean isUp() {
        return connection.isUp() || connection.isAsleep();
    }

    @Override
    public Optional<Instant> downSince() {
        return connection.downSince();
    }

    /** Port, problem or mode, and the numbers of good and bad frames. */
    @Override
    public String describe() {
        Telemetry now = reader.latest();
        String trouble = connection.trouble();
        if (!trouble.isEmpty() || now == null) {
            // Without a link, the problem already names the port.
            return connection.hasLink() && !connection.isDown() ? connection.description() + ": " + trouble : trouble;
        }
        return connection.description() + ", " + reader.describe(now);
    }

    /** Releases the robot as {@link #release()} does, and closes the link. Idempotent. */
    @Override
    public void close() {
        try {
            release();
        } catch (LinkException gone) {
            LOG.debug("{}", gone.getMessage());
        }
        connection.close();
    }
}
