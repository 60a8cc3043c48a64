package org.evoloop.roomba.simulator.webcam;

import java.io.IOException;
import java.net.InetAddress;
import java.net.URI;
import java.time.Duration;
import java.util.SplittableRandom;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;
import org.evoloop.roomba.simulator.eye.Eye;
import org.evoloop.roomba.simulator.robot.RobotState;
import org.evoloop.roomba.simulator.room.Pose;
import org.evoloop.roomba.simulator.webcam.Newest.Numbered;
import org.evoloop.time.Threads;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The robot's camera, served on this machine as motion JPEG, and the faults that cameras have. It gets every state
 * of the robot and shows the newest one at its frame rate, in the robot's time; without clients, nothing is drawn.
 * Neither drawing nor clients delay the thread that reports the states.
 *
 * <p>Threading: thread-safe; it draws on a thread of its own.
 *
 * @since 0.1
 */
public final class Webcam implements Consumer<RobotState>, AutoCloseable {
    private static final Logger LOG = LoggerFactory.getLogger(Webcam.class);

    private static final int MILLIS_PER_SECOND = 1000;
    private static final Duration END_LIMIT = Duration.ofSeconds(2);

    /** One damaged byte in so many; enough that no picture is left as it was. */
    private static final int BYTES_PER_DAMAGE = 1_000;

    /** The head of a JPEG; without it a client would not even know that it is one. */
    private static final int SPARED_BYTES = 700;

    private final WebcamOptions options;
    private final Newest<RobotState> moments = new Newest<>();
    private final Newest<byte[]> pictures = new Newest<>();
    private final Thread thread = new Thread(this::draw, "roomba-webcam");
    private final int port;
    private volatile @Nullable MjpegServer server;
    private volatile boolean stalled;
    private volatile double damagedShare;
    private final AtomicLong drawn = new AtomicLong();
    private long latestFrame = -1;
    private boolean closed;

    private Webcam(WebcamOptions options) throws IOException {
        this.options = options;
        MjpegServer first = new MjpegServer(pictures, options.port());
        server = first;
        port = first.port();
        thread.setDaemon(true);
    }

    /**
     * Begins to serve.
     *
     * @throws IOException if the port cannot be used; the message says what to do
     */
    public static Webcam start(WebcamOptions options) throws IOException {
        Webcam webcam = new Webcam(options);
        webcam.thread.start();
        return webcam;
    }

    /** The stream's address. */
    public URI url() {
        return URI.create(
                "http://" + InetAddress.getLoopbackAddress().getHostAddress() + ":" + port + MjpegServer.STREAM);
    }

    /** What it was made with. */
    public WebcamOptions options() {
        return options;
    }

    /** How many watch. */
    int clients() {
        MjpegServer current = server;
        return current == null ? 0 : current.clients();
    }

    /** How many pictures have been drawn. */
    public long drawn() {
        return drawn.get();
    }

    /** Takes the robot's state; returns at once. */
    @Override
    public void accept(RobotState state) {
        long frame = frame(state);
        if (clients() > 0 && !stalled && frame != latestFrame) {
            latestFrame = frame;
            moments.put(state);
        }
    }

    private long frame(RobotState state) {
        return (long) (state.timeMillis() * options.framesPerSecond() / MILLIS_PER_SECOND);
    }

    private void draw() {
        Eye eye = new Eye(options.eye());
        try (Jpeg jpeg = new Jpeg()) {
            Numbered<RobotState> moment = moments.after(0);
            while (moment != null) {
                RobotState state = moment.thing();
                double turnRadPerS = (state.rightMmPerS() - state.leftMmPerS()) / Pose.WHEEL_BASE_MM;
                byte[] bytes =
                        jpeg.encode(eye.render(state.surroundings().room(), state.pose(), turnRadPerS, frame(state)));
                damage(bytes, frame(state));
                drawn.incrementAndGet();
                if (!stalled) {
                    pictures.put(bytes);
                }
                moment = moments.after(moment.number());
            }
        } catch (InterruptedException ending) {
            Thread.currentThread().interrupt();
        }
    }

    private void damage(byte[] jpeg, long frame) {
        SplittableRandom random = new SplittableRandom(options.eye().seed() * 31 + frame);
        if (random.nextDouble() < damagedShare) {
            for (int i = 0; i < jpeg.length / BYTES_PER_DAMAGE + 1; i++) {
                int at = SPARED_BYTES + random.nextInt(Math.max(1, jpeg.length - SPARED_BYTES));
                jpeg[Math.min(at, jpeg.length - 1)] ^= (byte) (1 + random.nextInt(255));
            }
        }
    }

    /** Sends nothing any more, and keeps its clients waiting. */
    public void stall() {
        stalled = true;
    }

    /** Sends pictures again, and whole ones. */
    public void resume() {
        stalled = false;
        damagedShare = 0;
    }

    /**
     * Sends some of the pictures damaged.
     *
     * @param share of all pictures, 0 to 1
     */
    public void damage(double share) {
        if (!(share >= 0 && share <= 1)) {
            throw new IllegalArgumentException("the damaged share is " + share + "; allowed is 0 to 1");
        }
        damagedShare = share;
    }

    /**
     * Pulls the camera's cable: its clients are disconnected, and it cannot be reached.
     *
     * @throws IllegalArgumentException if it is unplugged already
     */
    public synchronized void unplug() {
        MjpegServer current = server;
        if (current == null) {
            throw new IllegalArgumentException("the camera is unplugged already");
        }
        server = null;
        current.close();
    }

    /**
     * Plugs the camera in again, at the same address.
     *
     * @throws IllegalArgumentException if it is plugged in already
     * @throws IOException if somebody else has taken its port
     */
    public synchronized void replug() throws IOException {
        if (server != null || closed) {
            throw new IllegalArgumentException("the camera is plugged in already");
        }
        server = new MjpegServer(pictures, port);
    }

    /** Hangs up and ends. A second call does nothing. */
    @Override
    public void close() {
        synchronized (this) {
            closed = true;
            MjpegServer current = server;
            server = null;
            if (current != null) {
                current.close();
            }
        }
        moments.close();
        pictures.close();
        if (!Threads.join(thread, END_LIMIT)) {
            LOG.warn("thread {} did not end within {} ms", thread.getName(), END_LIMIT.toMillis());
        }
    }
}
