package org.evoloop.roomba.session.connection;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.function.IntFunction;
import org.evoloop.link.Link;
import org.evoloop.link.LinkException;
import org.evoloop.link.LinkException.Fault;
import org.evoloop.roomba.oi.Command;
import org.evoloop.roomba.oi.InputCommand;
import org.evoloop.roomba.oi.PacketId;
import org.evoloop.roomba.session.connection.ConnectionState.Phase;
import org.evoloop.time.Clock;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Connects to the robot and stays connected: opens the link, wakes the robot, requests its stream, and starts again
 * when the cable was unplugged or the robot falls silent.
 *
 * <p>Lifecycle: see {@link ConnectionState}.
 *
 * <p>Without an answer at either rate the first time, {@link #firstAnswer()} fails; the connection keeps trying.
 *
 * <p>Threading: everything that may take a moment runs on one thread of its own, or, without waiting, on the clock's.
 * Each link is read on a thread named {@code roomba-reader}, or, without waiting, by {@link #poll}. Commands and {@link
 * #close()} may come from any thread.
 *
 * @since 0.1
 */
public final class RobotConnection {
    static final int BAUD = 115_200;
    static final int ALTERNATE_BAUD = 19_200;

    /** The pause that existing programs leave after a command that changes the mode. */
    public static final Duration MODE_CHANGE = Duration.ofMillis(20);

    /** How often the connection checks itself. */
    public static final Duration LOOK = Duration.ofMillis(250);

    /** A robot that is awake answers within a few frames; with a longer silence limit it also has more time. */
    public static final Duration ANSWER_LIMIT = Duration.ofSeconds(1);

    /** Longer than 500 ms: three shorter pulses after power-on would switch the robot to 19200 baud. */
    public static final Duration WAKE_PULSE = Duration.ofMillis(700);

    /** A robot in Passive mode falls asleep after five minutes; a pulse a minute keeps it awake. */
    static final Duration KEEP_AWAKE = Duration.ofMinutes(1);

    /** How often a sleeping robot is asked for its stream: it may have been woken and its messages lost. */
    public static final Duration ASK_SLEEPER = Duration.ofSeconds(5);

    /** After a change of the baud rate the robot needs 100 ms. */
    static final Duration BAUD_CHANGE = Duration.ofMillis(100);

    private static final Logger LOG = LoggerFactory.getLogger(RobotConnection.class);
    private static final int ATTEMPTS = 3;

    private static final String TRYING = "it is woken by its wake line and asked again, then also at " + ALTERNATE_BAUD
            + " baud. If it sleeps, press CLEAN on it";

    private final Plug plug;
    private final Clock clock;
    private final List<PacketId> stream;
    private final Duration silenceLimit;
    private final Duration answerLimit;
    private final ConnectionOwner owner;
    private final boolean mayWait;
    private final ConnectionThread thread;
    private final FirstAnswer firstAnswer = new FirstAnswer();
    private final ConnectionState state = new ConnectionState();
    private final Silence silence;
    private volatile Instant downSince = Instant.EPOCH;
    private volatile boolean attemptsReported;
    private volatile boolean maySleep;
    private boolean alternateTried;
    private int attempt;
    private long askedNanos;
    private long pulsedNanos;

    /** @param cable opens a new link to the robot at a baud rate; called again whenever the link was lost */
    public RobotConnection(IntFunction<Link> cable, Clock clock, ConnectionOptions options, ConnectionOwner owner) {
        this.plug = new Plug(cable);
        this.clock = clock;
        this.silence = new Silence(clock);
        this.stream = options.stream();
        this.silenceLimit = options.silenceLimit();
        this.answerLimit = longer(ANSWER_LIMIT, silenceLimit.dividedBy(2));
        this.owner = owner;
        this.mayWait = options.mayWait();
        this.thread = new ConnectionThread(clock, options.mayWait());
    }

    private static Duration longer(Duration one, Duration other) {
        return one.compareTo(other) >= 0 ? one : other;
    }

    /**
     * Opens the link for the first time.
     *
     * @throws LinkException if that cannot be done
     */
    public void open() {
        open(this::plugIn);
    }

    /**
     * As {@link #open}, for a robot that may come later: a problem is reported once, and the attempt repeated until
     * this is closed.
     *
     * @param firstGreeting run when the robot answers for the first time, on the thread that reads
     * @throws LinkException if the path exists but is not a port, or this user has no permission
     */
    public void openPatiently(Runnable firstGreeting) {
        firstAnswer.waitPatiently(firstGreeting);
        open(() -> {
            try {
                plugIn();
            } catch (LinkException notYet) {
                if (notYet.fault() == Fault.NOT_A_SERIAL_PORT || notYet.fault() == Fault.NO_PERMISSION) {
                    throw notYet;
                }
                state.enter(Phase.DOWN, String.valueOf(notYet.getMessage()));
                LOG.warn("{}; waiting for it", state.trouble());
            }
        });
    }

    private void open(Runnable plugging) {
        thread.runAndWait(() -> {
            pulsedNanos = clock.nanoTime();
            silence.broken();
            downSince = clock.wallTime();
            plugging.run();
            scheduleLook();
        });
    }

    /**
     * Completes with the first frame; with a {@link LinkException} if it is closed before. Unless it was opened
     * patiently, also with a {@link RobotException} if none comes, or a {@link LinkException} if the link is lost.
     */
    public CompletableFuture<Void> firstAnswer() {
        return firstAnswer.future();
    }

    /** Opens a link and requests the robot's stream. */
    private void plugIn() {
        plugIn(BAUD, Phase.ASKING);
        attempt = 1;
        ask();
    }

    private void plugIn(int baud, Phase next) {
        long plugging = plug.next();
        Link link = plug.open(baud);
        if (!state.enter(next, "no answer yet")) {
            // Closed meanwhile, by somebody who may not have seen this link.
            plug.close();
        } else if (mayWait) {
            plug.startReading(() -> readToTheEnd(link, plugging));
        }
    }

    private void readToTheEnd(Link link, long plugging) {
        boolean ended = false;
        while (!ended) {
            try {
                owner.read(link);
                ended = true;
            } catch (Throwable failure) {
                // Even an Error must not end this thread here, or the link would not be closed.
                LOG.error("{}: received data could not be handled", link.description(), failure);
            }
        }
        seeLoss(link, plugging);
    }

    /** Reads what has arrived, if the caller controls the time. */
    public void poll() {
        Link link = plug.link();
        if (link != null) {
            owner.read(link);
            seeLoss(link, plug.current());
        }
    }

    private void seeLoss(Link link, long plugging) {
        LinkException cause = link.loss();
        if (cause != null) {
            thread.run(() -> lose(plugging, cause));
        }
    }

    private void lose(long plugging, LinkException cause) {
        String trouble = String.valueOf(cause.getMessage());
        boolean news = plugging == plug.current() && state.phase() != Phase.DOWN;
        if (news && state.enter(Phase.DOWN, trouble)) {
            LOG.warn("{}", trouble);
            loseSight();
            firstAnswer.failed(cause);
            owner.outOfSight();
        }
    }

    private void loseSight() {
        downSince = silence.since();
    }

    private void ask() {
        if (state.phase() != Phase.ASKING) {
            // It answered during the wake pulse; a Start would now end its control.
            return;
        }
        if (attempt == 1) {
            askForStream(Phase.ASKING);
        } else {
            askedNanos = clock.nanoTime();
            plug.completeWhateverIsPending();
            askForStream(Phase.ASKING, MODE_CHANGE.plus(Plug.completionTime(BAUD)));
        }
    }

    private void askForStream(Phase asking) {
        askedNanos = clock.nanoTime();
        plug.trySend(new Command.Start());
        askForStream(asking, MODE_CHANGE);
    }

    private void askForStream(Phase asking, Duration pause) {
        later(pause, () -> {
            if (state.phase() == asking) {
                plug.trySend(new InputCommand.Stream(stream));
            }
        });
    }

    /** A frame was received. */
    public void answered() {
        silence.broken();
        if (state.enterFrom(Phase.ASKING, Phase.UP, "")) {
            attemptsReported = false;
            firstAnswer.came();
        }
    }

    private void scheduleLook() {
        silence.expectCheck(LOOK);
        thread.schedule(LOOK, () -> {
            try {
                look();
            } finally {
                scheduleLook();
            }
        });
    }

    private void look() {
        silence.checked();
        long now = clock.nanoTime();
        switch (state.phase()) {
            case UP -> {
                if (silence.hasLasted(silenceLimit)) {
                    if (maySleep && owner.isDrowsy()) {
                        fallAsleep();
                    } else {
                        fallSilent();
                    }
                } else if (!maySleep && now - pulsedNanos >= KEEP_AWAKE.toNanos() && owner.isDozing()) {
                    pulse(() -> {});
                    owner.keptAwake();
                }
            }
            case ASKING -> {
                if (now - askedNanos >= answerLimit.toNanos()) {
                    continueAsking();
                }
            }
            case DOWN -> replug();
            case ASLEEP -> {
                if (now - askedNanos >= ASK_SLEEPER.toNanos()) {
                    askForStream(Phase.ASLEEP);
                }
            }
            case NEW, CHANGING_RATE, CLOSED -> {}
        }
    }

    private void fallAsleep() {
        if (state.enterFrom(Phase.UP, Phase.ASLEEP, "asleep; the next event wakes it")) {
            askedNanos = clock.nanoTime();
            LOG.info("{}: the robot has fallen asleep", description());
            owner.outOfSight();
            owner.fellAsleep();
        }
    }

    /** Sets whether an unused robot may fall asleep; else it is kept awake. */
    public void letSleep(boolean may) {
        maySleep = may;
    }

    /** Whether the robot was allowed to fall asleep, and has done so. */
    public boolean isAsleep() {
        return state.phase() == Phase.ASLEEP;
    }

    /** Wakes a robot that is asleep; does not wait for it to answer. */
    public void wake() {
        thread.run(() -> {
            if (state.enterFrom(Phase.ASLEEP, Phase.ASKING, "it is being woken")) {
                attempt = 1;
                if (plug.setWakeLine(false)) {
                    askedNanos = clock.nanoTime() + WAKE_PULSE.toNanos();
                    pulse(this::ask);
                } else {
                    // Opening a port anew moves its lines; a simulated robot behind a pseudo-terminal takes that for a
                    // pulse.
                    plug.pull();
                    replug();
                }
            }
        });
    }

    /** Bytes were received: a robot that was asleep has been woken. */
    public void stirred() {
        if (isAsleep()) {
            thread.run(() -> {
                if (state.enterFrom(Phase.ASLEEP, Phase.ASKING, "it wakes")) {
                    attempt = 1;
                    ask();
                }
            });
        }
    }

    private void fallSilent() {
        if (state.enterFrom(Phase.UP, Phase.ASKING, "the robot has fallen silent; " + TRYING)) {
            LOG.warn("{}: {}", description(), state.trouble());
            attemptsReported = true;
            loseSight();
            attempt = 1;
            owner.outOfSight();
            ask();
        }
    }

    private void replug() {
        try {
            plugIn();
        } catch (LinkException stillGone) {
            state.enter(Phase.DOWN, String.valueOf(stillGone.getMessage()));
            firstAnswer.failed(stillGone);
        }
    }

    /** Wakes the robot and asks again; after some attempts tries the other baud rate, at first only once. */
    private void continueAsking() {
        // The next check must not get here before the request was sent.
        askedNanos = clock.nanoTime() + WAKE_PULSE.toNanos();
        attempt++;
        if (attempt <= ATTEMPTS) {
            reportAttempts();
            pulse(this::ask);
        } else if (!alternateTried) {
            alternateTried = true;
            changeRate();
        } else {
            String known = owner.frameTrouble();
            firstAnswer.failed(new RobotException(
                    known.isEmpty() ? owner.firstBytes().diagnosis(description()) : description() + ": " + known));
            alternateTried = false;
            plug.pull();
            replug();
        }
    }

    private void reportAttempts() {
        if (!attemptsReported && state.enterFrom(Phase.ASKING, Phase.ASKING, noAnswer() + "; " + TRYING)) {
            attemptsReported = true;
            LOG.warn("{}: {}", description(), state.trouble());
        }
    }

    private String noAnswer() {
        String known = owner.frameTrouble();
        return known.isEmpty()
                ? owner.firstBytes().isEmpty() ? "no answer yet" : "bytes come, but no frames yet"
                : known;
    }

    /** The robot may use the alternate rate; sends it the command there to return to the usual one. */
    private void changeRate() {
        plug.pull();
        try {
            plugIn(ALTERNATE_BAUD, Phase.CHANGING_RATE);
        } catch (LinkException refused) {
            LOG.debug("{}", refused.getMessage());
            replug();
            return;
        }
        // Bytes received at the wrong rate may have started any command.
        plug.completeWhateverIsPending();
        later(MODE_CHANGE.plus(Plug.completionTime(ALTERNATE_BAUD)), () -> {
            plug.trySend(new Command.Baud(BAUD));
            later(BAUD_CHANGE, () -> {
                plug.pull();
                replug();
            });
        });
    }

    private void pulse(Runnable then) {
        pulsedNanos = clock.nanoTime();
        plug.setWakeLine(true);
        later(WAKE_PULSE, () -> {
            plug.setWakeLine(false);
            then.run();
        });
    }

    /** Schedules work for the current link; it is skipped if the link was replaced or closed by then. */
    private void later(Duration delay, Runnable work) {
        long plugging = plug.current();
        thread.schedule(delay, () -> {
            boolean usable = state.phase() != Phase.DOWN && state.phase() != Phase.CLOSED;
            if (usable && plugging == plug.current()) {
                work.run();
            }
        });
    }

    /**
     * Sends bytes.
     *
     * @throws LinkException if the robot cannot be reached
     */
    public void send(byte[] bytes) {
        if (state.phase() == Phase.DOWN) {
            throw new LinkException(Fault.HUNG_UP, state.trouble());
        }
        plug.send(bytes);
    }

    /** Sends a command if possible; else does nothing. */
    public void trySend(Command command) {
        plug.trySend(command);
    }

    /** Completes a command that the robot may have received in part; ends its control. */
    public void completeWhateverIsPending() {
        plug.completeWhateverIsPending();
    }

    /** Whether the robot is sending. */
    public boolean isUp() {
        return state.phase() == Phase.UP;
    }

    /** Whether there is no link to the robot. */
    public boolean isDown() {
        return state.phase() == Phase.DOWN;
    }

    /** The time of day since which the robot is silent; empty while it is sending, or asleep. */
    public Optional<Instant> downSince() {
        return isUp() || isAsleep() ? Optional.empty() : Optional.of(downSince);
    }

    /** The problem; empty if there is none. It names the port only if there is no link. */
    public String trouble() {
        return state.trouble();
    }

    /** Whether there has been a link yet. */
    public boolean hasLink() {
        return plug.link() != null;
    }

    /** What it is connected to, for messages: the port and its settings. */
    public String description() {
        return plug.description();
    }

    /** Closes the link; nothing is sent after that. Waits for the connection's thread. Idempotent. */
    public void close() {
        state.enter(Phase.CLOSED, "closed");
        firstAnswer.ended(new LinkException(Fault.CLOSED, description() + " was closed before the robot answered"));
        plug.close();
        thread.close();
    }
}
