package org.evoloop.service;

import static java.util.Objects.requireNonNull;

import java.io.IOException;
import java.time.Duration;
import java.util.Locale;
import java.util.concurrent.locks.LockSupport;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.evoloop.time.Threads;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Uses a separate process to make a device safe, within a second, if this process ends in any way other than {@link
 * #close} or stops running: stopped by a signal, starved, or hung in the code that handles the device.
 *
 * <p>While the device is active, the guard process gets a heartbeat every {@value #BEAT_MILLIS} ms; it acts when there
 * has been none for {@link #LIMIT}. This process detects that by its own clock, a little earlier: from then on {@link
 * #maySend} is false, so that a process that continues after a standstill sends the device nothing decided before.
 *
 * <p>A guard process that ends, or that does not answer while the device is active, is replaced within a second.
 *
 * <p>Threading: thread-safe. Runs its own thread, in real time.
 *
 * @since 0.1
 */
public final class DeviceGuard implements AutoCloseable {
    /** How long this process may be silent before the device is made safe. */
    public static final Duration LIMIT = Duration.ofMillis(500);

    private static final Logger LOG = LoggerFactory.getLogger(DeviceGuard.class);
    private static final int BEAT_MILLIS = 100;
    private static final long BEAT_NANOS = Duration.ofMillis(BEAT_MILLIS).toNanos();

    /** Ends before the guard process can act. */
    private static final long FENCE_NANOS = LIMIT.toNanos() - BEAT_NANOS;

    /** After a command, a device counts as active for this long, whatever it reports. */
    private static final long SENDING_NANOS = Duration.ofSeconds(1).toNanos();

    /**
     * A guard process that leaves this many heartbeats unanswered is replaced. Heartbeats are counted, since time in
     * which this process does not run is not the guard process's fault.
     */
    private static final int UNANSWERED_BEATS = 5;

    /** The same for one that has not answered yet, which may be slow to start on a busy computer. */
    private static final int UNANSWERED_BEATS_AT_START = 50;

    private static final long RESTART_NANOS = Duration.ofSeconds(1).toNanos();

    private static final Pattern ANSWER = Pattern.compile("(on|safe|failed) (\\d+)");

    private final GuardedDevice device;
    private final Thread thread;
    private GuardProcess process;
    private long startedNanos = System.nanoTime();
    private boolean watching;
    private long beats;

    /** The last beat before the process was started, and the last one that counts as answered. */
    private long startedBeat;

    private long answeredBeat;

    /** The first beat since the device became active. */
    private long firstBeat;

    private long beatNanos;
    private long sendingNanos = startedNanos - SENDING_NANOS;

    /** The reason why the device is being made safe; null if it is not. */
    private @Nullable String expired;

    private boolean failing;
    private volatile boolean closed;

    private DeviceGuard(GuardedDevice device) throws IOException {
        this.device = requireNonNull(device, "the guarded device is null");
        this.process = begin();
        this.thread = new Thread(this::run, "evoloop-guard");
        thread.setDaemon(true);
    }

    /**
     * Starts the guard process.
     *
     * @throws IOException if this system lacks bash or setsid (util-linux)
     */
    public static DeviceGuard start(GuardedDevice device) throws IOException {
        DeviceGuard guard = new DeviceGuard(device);
        guard.thread.start();
        return guard;
    }

    private GuardProcess begin() throws IOException {
        return new GuardProcess(LIMIT, device.makeSafeCommand(), this::heard);
    }

    /**
     * Whether this process has been running without interruption. Call it before sending the device anything that may
     * make it active. If it returns false, send the device nothing before {@link GuardedDevice#madeSafe} has returned.
     */
    public synchronized boolean maySend() {
        long now = System.nanoTime();
        sendingNanos = now;
        if (expire(now)) {
            return false;
        }
        if (!watching) {
            beat(now);
        }
        return true;
    }

    /** The status of the guard process, for people. */
    public synchronized String describe() {
        return process.isAlive() ? "guarded by process " + process.pid() : "NOT guarded: the guard process has ended";
    }

    /** Whether the guard process has answered since its start. */
    synchronized boolean isAnswered() {
        return answeredBeat > startedBeat;
    }

    private void run() {
        long next = System.nanoTime();
        while (!closed) {
            next = Math.max(next + BEAT_NANOS, System.nanoTime());
            while (!closed && next - System.nanoTime() > 0) {
                LockSupport.parkNanos(this, next - System.nanoTime());
            }
            try {
                look();
            } catch (RuntimeException failure) {
                LOG.error("the guarded device could not be checked", failure);
            }
        }
    }

    private void look() {
        boolean active = device.isActive();
        String reason = beatUnlessExpired(active);
        if (reason != null) {
            LOG.warn("{}", reason);
            device.madeSafe(reason);
            proceed();
        }
    }

    private synchronized @Nullable String beatUnlessExpired(boolean active) {
        long now = System.nanoTime();
        if (expire(now)) {
            process.send("stop");
            return expired;
        }
        replaceIfUseless(now);
        if (active || now - sendingNanos < SENDING_NANOS) {
            beat(now);
        } else if (watching) {
            watching = false;
            process.send("off");
        }
        return null;
    }

    private void beat(long now) {
        beats++;
        if (!watching) {
            watching = true;
            firstBeat = beats;
        }
        // Taken before the beat is written, since this process may be stopped in between; then the guard has not
        // received it.
        beatNanos = now;
        process.send("on " + beats);
    }

    /** Whether the guard process has acted, or is about to. */
    private boolean expire(long now) {
        long stood = now - beatNanos;
        if (expired == null && watching && stood >= FENCE_NANOS) {
            expired = String.format(
                    Locale.ROOT,
                    "this program was frozen for %.1f s, so the device was put into a safe state",
                    stood / 1e9);
        }
        return expired != null;
    }

    private synchronized void proceed() {
        expired = null;
        watching = false;
    }

    private synchronized void heard(String line) {
        Matcher answer = ANSWER.matcher(line);
        if (!answer.matches()) {
            return;
        }
        long beat = Long.parseLong(answer.group(2));
        answeredBeat = Math.max(answeredBeat, beat);
        boolean acted = !answer.group(1).equals("on") && watching && beat >= firstBeat;
        if (acted && !expire(System.nanoTime())) {
            expired = "the guard process got no sign of life from this program in time, so the device was put into a "
                    + "safe state";
        }
    }

    private void replaceIfUseless(long now) {
        int patience = isAnswered() ? UNANSWERED_BEATS : UNANSWERED_BEATS_AT_START;
        boolean hung = beats - answeredBeat >= patience;
        if ((process.isAlive() && !hung) || now - startedNanos < RESTART_NANOS) {
            return;
        }
        startedNanos = now;
        startedBeat = beats;
        answeredBeat = beats;
        try {
            process.kill();
            process = begin();
            failing = false;
            LOG.warn("the guard process {}; another one is started", hung ? "does not answer" : "has ended");
        } catch (IOException failure) {
            if (!failing) {
                failing = true;
                LOG.error("nothing guards the device: {}", failure.getMessage());
            }
        }
    }

    /** Ends the guard, when the process is about to end and the device is safe. Idempotent. */
    @Override
    public void close() {
        closed = true;
        LockSupport.unpark(thread);
        Threads.join(thread, Duration.ofSeconds(1));
        synchronized (this) {
            process.send("end");
        }
    }
}
