package org.evoloop.roomba.session;

import java.time.Duration;
import java.util.Arrays;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.RejectedExecutionException;
import java.util.function.IntFunction;
import org.evoloop.roomba.link.Link;
import org.evoloop.roomba.link.LinkException;
import org.evoloop.roomba.oi.Command;
import org.evoloop.roomba.oi.InputCommand;
import org.evoloop.roomba.oi.Opcode;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Gets the robot on the line and keeps it there: opens the link, wakes the robot, asks for its stream, and begins anew
 * when the cable was pulled or the robot falls silent.
 *
 * <pre>
 *   open() --&gt; ASKING --frame--&gt; UP --silence--&gt; ASKING
 *                |  |             |
 *                |  '--lost-------+--lost--&gt; DOWN --link opens--&gt; ASKING
 *                '--no answer at 115200 nor 19200, the first time--&gt; failed
 * </pre>
 *
 * <p>Threading: everything that may take a moment runs on one thread of its own, or, without waiting, on the clock's.
 */
final class Connection {
    static final int BAUD = 115_200;
    static final int ALTERNATE_BAUD = 19_200;

    /** Field code leaves this much after a command that changes the mode. */
    static final Duration MODE_CHANGE = Duration.ofMillis(20);

    /** How often the connection looks after itself. */
    static final Duration LOOK = Duration.ofMillis(250);

    /** A robot that is awake answers within a few frames. */
    static final Duration ANSWER_LIMIT = Duration.ofSeconds(1);

    /** Longer than 500 ms: three shorter pulses after power-on would switch the robot to 19200 baud. */
    static final Duration WAKE_PULSE = Duration.ofMillis(700);

    /** A robot in Passive mode falls asleep after five minutes; a pulse a minute keeps it awake. */
    static final Duration KEEP_AWAKE = Duration.ofMinutes(1);

    /** After a change of the baud rate the robot needs 100 ms. */
    static final Duration BAUD_CHANGE = Duration.ofMillis(100);

    private static final Logger LOG = LoggerFactory.getLogger(RoombaSession.class);
    private static final int ATTEMPTS = 3;

    /** A stream of 255 packets. */
    private static final int LONGEST_COMMAND = 257;

    /** What the owner of the connection is told, on the thread that receives or on the connection's own. */
    interface Owner {
        void received(byte[] buffer, int length);

        /** The robot is out of sight. */
        void outOfSight();

        /** Whether the robot may be kept awake by a pulse now: it is on its own and does nothing. */
        boolean isDozing();
    }

    private enum State {
        NEW,
        ASKING,
        UP,
        DOWN,
        CLOSED
    }

    private final IntFunction<Link> cable;
    private final Clock clock;
    private final Duration silenceLimit;
    private final Owner owner;
    private final @Nullable ExecutorService thread;
    private final Executor own;
    private final CompletableFuture<Void> firstAnswer = new CompletableFuture<>();
    private final FirstBytes firstBytes = new FirstBytes();
    private volatile State state = State.NEW;
    private volatile @Nullable Link link;
    private volatile String trouble = "";
    private volatile long lastFrameNanos;
    private int baud = BAUD;
    private int attempt;
    private long askedNanos;
    private long pulsedNanos;
    private long generation;

    Connection(IntFunction<Link> cable, Clock clock, SessionOptions options, Owner owner) {
        this.cable = cable;
        this.clock = clock;
        this.silenceLimit = options.silenceLimit();
        this.owner = owner;
        this.thread = options.mayWait() ? Executors.newSingleThreadExecutor(Connection::thread) : null;
        this.own = thread != null ? thread : Runnable::run;
    }

    private static Thread thread(Runnable work) {
        Thread made = new Thread(work, "roomba-connection");
        made.setDaemon(true);
        return made;
    }

    /** Opens the link for the first time. @throws LinkException if that cannot be done */
    void open() {
        pulsedNanos = clock.nanoTime();
        plugIn();
        later(LOOK, this::look);
    }

    /** Completes with the first frame, or with a {@link RobotException} if none comes. */
    CompletableFuture<Void> firstAnswer() {
        return firstAnswer;
    }

    private void plugIn() {
        long ofGeneration = ++generation;
        Link fresh = cable.apply(baud);
        fresh.open(new Link.Receiver() {
            @Override
            public void received(byte[] buffer, int length) {
                firstBytes.take(buffer, length);
                owner.received(buffer, length);
            }

            @Override
            public void lost(LinkException cause) {
                run(() -> lose(ofGeneration, cause));
            }
        });
        link = fresh;
        state = State.ASKING;
        trouble = "no answer yet";
        attempt = 1;
        ask();
    }

    private void lose(long ofGeneration, LinkException cause) {
        if (ofGeneration == generation && state != State.CLOSED && state != State.DOWN) {
            LOG.warn("{}", cause.getMessage());
            trouble = String.valueOf(cause.getMessage());
            state = State.DOWN;
            owner.outOfSight();
        }
    }

    private void ask() {
        askedNanos = clock.nanoTime();
        if (attempt == 1) {
            trySend(new Command.Start());
        } else {
            completeWhateverIsPending();
        }
        later(MODE_CHANGE, () -> {
            if (state == State.ASKING) {
                trySend(new InputCommand.Stream(RoombaSession.STREAM));
            }
        });
    }

    /** Sends a command if that can be done; nobody is told if not. */
    void trySend(Command command) {
        trySend(command.bytes());
    }

    /**
     * A robot that has received only a part of a command waits for the rest, for ever (specification, "Roomba Open
     * Interface Commands"). Repeated Start commands complete whatever it is: they are no valid data for a change of the
     * baud rate, and as commands do no harm to a robot that is not under control.
     */
    void completeWhateverIsPending() {
        byte[] starts = new byte[LONGEST_COMMAND];
        Arrays.fill(starts, (byte) Opcode.START.code());
        trySend(starts);
    }

    private void trySend(byte[] bytes) {
        Link current = link;
        if (current != null) {
            try {
                current.send(bytes);
            } catch (LinkException gone) {
                LOG.debug("{}", gone.getMessage());
            }
        }
    }

    /** A frame has come. */
    void answered() {
        lastFrameNanos = clock.nanoTime();
        if (state == State.ASKING) {
            state = State.UP;
            trouble = "";
            firstAnswer.complete(null);
        }
    }

    private void look() {
        long now = clock.nanoTime();
        switch (state) {
            case UP -> {
                if (now - lastFrameNanos >= silenceLimit.toNanos()) {
                    LOG.warn("{}: the robot has fallen silent", description());
                    state = State.ASKING;
                    trouble = "the robot has fallen silent";
                    attempt = 1;
                    owner.outOfSight();
                    ask();
                } else if (now - pulsedNanos >= KEEP_AWAKE.toNanos() && owner.isDozing()) {
                    pulse(() -> {});
                }
            }
            case ASKING -> {
                if (now - askedNanos >= ANSWER_LIMIT.toNanos()) {
                    goOnAsking();
                }
            }
            case DOWN -> replug();
            default -> {
                return;
            }
        }
        later(LOOK, this::look);
    }

    private void replug() {
        try {
            baud = BAUD;
            plugIn();
        } catch (LinkException stillGone) {
            trouble = String.valueOf(stillGone.getMessage());
        }
    }

    /** Wakes the robot and asks again; after some attempts tries the other baud rate, at first only once. */
    private void goOnAsking() {
        // The next look must not come here before the question was asked.
        askedNanos = clock.nanoTime() + WAKE_PULSE.toNanos();
        attempt++;
        if (attempt <= ATTEMPTS) {
            pulse(this::ask);
        } else if (baud == BAUD) {
            changeBaud();
        } else if (!firstAnswer.isDone()) {
            firstAnswer.completeExceptionally(new RobotException(firstBytes.diagnosis(description())));
        } else {
            replugAt(BAUD);
        }
    }

    /** The robot may listen at the alternate rate; then it is told to come back to the usual one. */
    private void changeBaud() {
        replugAt(ALTERNATE_BAUD);
        later(MODE_CHANGE, () -> trySend(new Command.Baud(BAUD)));
        later(BAUD_CHANGE.plus(MODE_CHANGE), () -> {
            if (state == State.ASKING) {
                replugAt(BAUD);
                // From here on a missing answer is final.
                baud = ALTERNATE_BAUD;
            }
        });
    }

    private void replugAt(int nextBaud) {
        closeLink();
        baud = nextBaud;
        try {
            plugIn();
        } catch (LinkException gone) {
            state = State.DOWN;
            trouble = String.valueOf(gone.getMessage());
            firstAnswer.completeExceptionally(gone);
        }
    }

    private void pulse(Runnable then) {
        Link current = link;
        pulsedNanos = clock.nanoTime();
        if (current != null) {
            current.wakeLine().setLow(true);
            later(WAKE_PULSE, () -> {
                current.wakeLine().setLow(false);
                then.run();
            });
        }
    }

    private void later(Duration delay, Runnable work) {
        clock.schedule(
                delay,
                () -> run(() -> {
                    if (state != State.CLOSED) {
                        work.run();
                    }
                }));
    }

    private void run(Runnable work) {
        try {
            own.execute(work);
        } catch (RejectedExecutionException closed) {
            LOG.debug("too late: the connection is closed");
        }
    }

    /** Sends bytes. @throws LinkException if the robot cannot be reached */
    void send(byte[] bytes) {
        Link current = link;
        if (current == null || state == State.DOWN) {
            throw new LinkException(LinkException.Fault.HUNG_UP, description() + ": " + trouble);
        }
        current.send(bytes);
    }

    boolean isUp() {
        return state == State.UP;
    }

    /** What is wrong; empty if nothing is. */
    String trouble() {
        return trouble;
    }

    String description() {
        Link current = link;
        return current == null ? "no link" : current.description();
    }

    /** Closes the link; nothing is sent any more. Idempotent. */
    void close() {
        state = State.CLOSED;
        if (thread != null) {
            thread.shutdown();
        }
        closeLink();
    }

    private void closeLink() {
        generation++;
        Link current = link;
        if (current != null) {
            current.close();
        }
    }
}
