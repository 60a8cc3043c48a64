package org.evoloop.roomba.session;

import java.time.Duration;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import org.evoloop.roomba.link.Link;
import org.evoloop.roomba.link.LinkException;
import org.evoloop.roomba.oi.Button;
import org.evoloop.roomba.oi.Command;
import org.evoloop.roomba.oi.InputCommand;
import org.evoloop.roomba.oi.OiMode;
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
public final class RoombaSession implements AutoCloseable {
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
            Packet.LEFT_WHEEL_CURRENT,
            Packet.RIGHT_WHEEL_CURRENT,
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
    private final List<SessionListener> listeners = new CopyOnWriteArrayList<>();
    private final StreamFramer framer = new StreamFramer(STREAM, this::framed);
    private final ButtonPresses buttons = new ButtonPresses();
    private final Odometry odometry = new Odometry();
    private final SpotWatch spotWatch = new SpotWatch();
    private final CountDownLatch answered = new CountDownLatch(1);
    private long frames;
    private boolean wasActive;
    private volatile @Nullable Telemetry latest;
    private volatile @Nullable LinkException lost;
    private volatile boolean closed;

    public RoombaSession(Link link, Clock clock) {
        this.link = link;
        this.clock = clock;
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
                synchronized (framer) {
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
     * Waits for the robot to answer, waking it if it does not.
     *
     * @throws RobotException if it stays silent
     * @throws InterruptedException if the thread is told to stop while it waits
     */
    public void awaitRobot() throws InterruptedException {
        for (int attempt = 1; attempt <= ATTEMPTS; attempt++) {
            Clock.Timer limit = clock.schedule(ANSWER_LIMIT, this::wakeWaiter);
            awaitAnswerOrLimit();
            limit.cancel();
            if (latest != null) {
                return;
            }
            LOG.info("{}: no answer yet", link.description());
            if (attempt < ATTEMPTS) {
                // One long pulse: three short ones would switch the robot to 19200 baud.
                link.wakeLine().setLow(true);
                clock.sleep(WAKE_PULSE);
                link.wakeLine().setLow(false);
                clock.sleep(MODE_CHANGE);
                ask();
            }
        }
        throw new RobotException(link.description() + ": the robot does not answer. Is it switched on and awake (press "
                + "CLEAN), is the cable in its port, and is this the port that the cable is on?");
    }

    private final Object waiter = new Object();
    private boolean limitReached;

    private void wakeWaiter() {
        synchronized (waiter) {
            limitReached = true;
            waiter.notifyAll();
        }
    }

    private void awaitAnswerOrLimit() throws InterruptedException {
        synchronized (waiter) {
            limitReached = false;
            while (latest == null && !limitReached) {
                waiter.wait();
            }
        }
    }
}
