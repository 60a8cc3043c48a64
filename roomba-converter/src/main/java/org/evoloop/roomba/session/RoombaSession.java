package org.evoloop.roomba.session;

import java.time.Duration;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.ExecutionException;
import java.util.function.IntFunction;
import org.evoloop.converter.DeviceLink;
import org.evoloop.roomba.link.Link;
import org.evoloop.roomba.link.LinkException;
import org.evoloop.roomba.oi.ActuatorCommand;
import org.evoloop.roomba.oi.Button;
import org.evoloop.roomba.oi.Command;
import org.evoloop.roomba.oi.Packet;
import org.evoloop.roomba.oi.PacketId;
import org.evoloop.roomba.oi.SensorValues;
import org.evoloop.roomba.oi.StreamFramer;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A conversation with a Roomba: one stream of sensor values, which is the session's only source, and commands. It outlives
 * a cable that is pulled and plugged in again, and a robot that sleeps.
 *
 * <p>Lifecycle: {@link #open}, then {@link #awaitRobot}; {@link #close} leaves the robot stopped and in Passive mode.
 *
 * <p>Threading: all methods may be called from any thread. Listeners are called on the link's thread.
 */
public final class RoombaSession implements DeviceLink, AutoCloseable {
    /** All that is looked at, 48 bytes a frame: fits 57600 baud and above. */
    static final List<PacketId> STREAM = List.of(
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
            Packet.CHARGING_SOURCES,
            Packet.OI_MODE,
            Packet.LEFT_ENCODER,
            Packet.RIGHT_ENCODER,
            Packet.LIGHT_BUMPER,
            Packet.LEFT_MOTOR_CURRENT,
            Packet.RIGHT_MOTOR_CURRENT,
            Packet.MAIN_BRUSH_CURRENT,
            Packet.SIDE_BRUSH_CURRENT);

    private static final Logger LOG = LoggerFactory.getLogger(RoombaSession.class);

    /** So many frames after it came back into sight it is plain what the robot does. */
    private static final int SETTLING_FRAMES = 4;

    /** A command that ends control shows within a few frames. */
    private static final int CONFIRM_FRAMES = 10;

    private final Clock clock;
    private final SessionOptions options;
    private final Connection connection;
    private final List<SessionListener> listeners = new CopyOnWriteArrayList<>();
    private final Object receiving = new Object();
    private final Object sending = new Object();
    private final StreamFramer framer = new StreamFramer(STREAM, this::framed);
    private final FrameFilter filter;
    private final ButtonPresses buttons = new ButtonPresses();
    private final Odometry odometry = new Odometry();
    private final SpotWatch spotWatch = new SpotWatch();
    private final ActivityWatch activityWatch = new ActivityWatch();
    private final ActivityEstimate estimate = new ActivityEstimate();
    private boolean modeChanged;
    private long modeChangedNanos;
    private @Nullable Command unconfirmed;
    private int framesOfControl;
    private boolean outOfSight;
    private int settlingFrames;
    private int framesWithoutControl;
    private volatile boolean regaining;
    private volatile boolean engaged;
    private volatile boolean wantsControl;
    private volatile @Nullable Telemetry latest;

    /**
     * @param cable makes a new link to the robot at a baud rate; called again whenever the link was lost
     */
    public RoombaSession(IntFunction<Link> cable, Clock clock, SessionOptions options) {
        this.clock = clock;
        this.options = options;
        this.filter = new FrameFilter(options.modeOffset());
        this.connection = new Connection(cable, clock, options, new Connection.Owner() {
            @Override
            public void received(byte[] buffer, int length) {
                synchronized (receiving) {
                    framer.feed(buffer, 0, length);
                }
            }

            @Override
            public void outOfSight() {
                loseSight();
            }

            @Override
            public boolean isDozing() {
                return !isUnderControl() && isAtRest();
            }
        });
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

    /** One frame has come; called on the link's thread. */
    private void framed(SensorValues raw) {
        SensorValues values = filter.filter(raw);
        Telemetry earlier = latest;
        Telemetry now = new Telemetry(earlier == null ? 1 : earlier.frame() + 1, values, odometry.update(values));
        latest = now;
        // Who waits for the robot finds its values.
        connection.answered();
        listeners.forEach(listener -> listener.received(now));
        comeBackIntoSight();
        seeControl(now.isUnderControl(), earlier != null && earlier.isUnderControl());
        tellPresses(now);
        SpotWatch.Ending ending = spotWatch.update(values);
        if (ending != null) {
            estimate.seenAtRest();
            listeners.forEach(listener -> listener.spotEnded(ending));
        }
        ActivityWatch.Seen seen = activityWatch.update(values, now.isUnderControl());
        if (seen == ActivityWatch.Seen.AT_REST) {
            estimate.seenAtRest();
            tellActivity();
        } else if (seen == ActivityWatch.Seen.AT_WORK && !wantsControl) {
            estimate.seenAtWork();
            tellActivity();
        }
        keepControl(now);
    }

    private void tellPresses(Telemetry now) {
        for (Button button : buttons.update(now.values().buttons())) {
            boolean robotActs = !now.isUnderControl();
            listeners.forEach(listener -> listener.pressed(button, robotActs));
            if (robotActs) {
                estimate.pressed(button);
                // What the motors did before says nothing about what comes of the press.
                activityWatch.forget();
                if (estimate.activity().isWork()) {
                    activityWatch.expected();
                }
                if (estimate.activity() == ActivityEstimate.Activity.SPOT) {
                    spotWatch.started();
                } else {
                    spotWatch.forget();
                }
                tellActivity();
            }
        }
    }

    /** Tells what the robot does, as far as it is one of the things that its model knows. */
    private void tellActivity() {
        switch (estimate.activity()) {
            case ON -> tell(SessionListener.Activity.ON);
            case CLEAN -> tell(SessionListener.Activity.CLEAN);
            case SPOT -> tell(SessionListener.Activity.SPOT);
            default -> LOG.debug("the robot is in {}", estimate.activity());
        }
    }

    private void tell(SessionListener.Activity activity) {
        listeners.forEach(listener -> listener.seen(activity));
    }

    private void loseSight() {
        synchronized (receiving) {
            outOfSight = true;
            settlingFrames = SETTLING_FRAMES;
            spotWatch.forget();
            activityWatch.forget();
        }
    }

    /**
     * The robot is back. What its owner did to it meanwhile cannot be told from what it shows: cleaning and spot cleaning
     * look alike. So if it is to be controlled at all, control is taken, which ends whatever it does; then it is on.
     */
    private void comeBackIntoSight() {
        if (outOfSight && --settlingFrames <= 0) {
            outOfSight = false;
            regaining = engaged;
            if (regaining) {
                connection.trySend(new Command.Safe());
                connection.trySend(new ActuatorCommand.DriveDirect(0, 0));
            }
        }
    }

    private void seeControl(boolean underControl, boolean before) {
        if (underControl && !before) {
            // Only when it begins: a command that ends control takes some frames to show.
            estimate.controlled();
        }
        if (underControl && regaining) {
            regaining = false;
            tell(SessionListener.Activity.ON);
        }
        Command command = unconfirmed;
        framesOfControl = underControl ? framesOfControl + 1 : 0;
        if (!underControl) {
            unconfirmed = null;
        } else if (command != null && framesOfControl % CONFIRM_FRAMES == 0) {
            // It would have ended control, had the robot received it.
            connection.trySend(command);
        } else if (command == null && engaged && !wantsControl && framesOfControl % SpotWatch.QUIET_FRAMES == 0) {
            // Whatever it was left alone for, it does not do it.
            tell(SessionListener.Activity.ON);
        }
    }

    /**
     * The robot leaves Safe mode by itself, for instance when it is lifted, and a command may be lost on a noisy line: it
     * is taken back, tried again until it obeys.
     */
    private void keepControl(Telemetry now) {
        SensorValues values = now.values();
        boolean mayTake = (wantsControl || regaining)
                && !outOfSight
                && !now.isUnderControl()
                && !values.anyWheelDrop()
                && values.value(Packet.CHARGING_SOURCES) == 0;
        framesWithoutControl = mayTake ? framesWithoutControl + 1 : 0;
        int tries = framesWithoutControl / SpotWatch.QUIET_FRAMES;
        if (tries > 0 && framesWithoutControl % SpotWatch.QUIET_FRAMES == 0) {
            if (tries % 2 == 0) {
                connection.completeWhateverIsPending();
            } else {
                connection.trySend(new Command.Safe());
            }
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
        if (regaining) {
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
            estimate.commanded(command);
            unconfirmed = null;
            if (command instanceof Command.Spot || command instanceof Command.Clean) {
                activityWatch.expected();
                unconfirmed = isUnderControl() ? command : null;
                // Counted anew: the frames that are on their way still show control.
                framesOfControl = 0;
            }
            if (command instanceof Command.Spot && estimate.activity() == ActivityEstimate.Activity.SPOT) {
                spotWatch.started();
            }
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
        engaged = true;
        wantsControl = true;
        if (!isUnderControl()) {
            send(new Command.Safe());
        }
    }

    /** Leaves the robot to itself for now; if it comes back from out of sight, control is taken. */
    public void leaveAlone() {
        engaged = true;
        wantsControl = false;
    }

    /** Stops the wheels if the robot is under control or about to be, and gives it back to itself for good. */
    public void letGo() {
        // Control that was just asked for may show only in the next frame.
        boolean mayHaveControl = wantsControl || regaining || isUnderControl();
        engaged = false;
        wantsControl = false;
        regaining = false;
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

    private boolean isAtRest() {
        synchronized (receiving) {
            return activityWatch.restFrames() >= SpotWatch.QUIET_FRAMES;
        }
    }

    @Override
    public boolean isUp() {
        return connection.isUp();
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
            return connection.description() + ", mode " + mode + ", " + framer.frames() + " frames, "
                    + framer.badChecksums() + " bad, " + framer.skippedBytes() + " bytes skipped";
        }
    }

    /** Leaves the robot stopped and in Passive mode, and closes the link. Idempotent. */
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
