package org.evoloop.roomba.session;

import java.time.Duration;
import java.util.Arrays;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.Executor;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.TimeUnit;
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
 *               |  ^  \             \
 *     no answer |  |   '--lost--------+--lost--&gt; DOWN --link opens--&gt; ASKING
 *               v  | at 115200
 *              CHANGING_RATE
 *
 *   close() --&gt; CLOSED, from wherever it is, for good
 * </pre>
 *
 * <p>Without an answer at either rate the first time, {@link #firstAnswer()} fails; the connection goes on asking.
 *
 * <p>Threading: everything that may take a moment runs on one thread of its own, or, without waiting, on the clock's.
 * Frames come on the link's thread, commands and {@link #close()} from any.
 */
final class Connection {
    static final int BAUD = 115_200;
    static final int ALTERNATE_BAUD = 19_200;

    /** Field code leaves this much after a command that changes the mode. */
    static final Duration MODE_CHANGE = Duration.ofMillis(20);

    /** How often the connection looks after itself. */
    static final Duration LOOK = Duration.ofMillis(250);

    /** A robot that is awake answers within a few frames; more time has one whose silence is borne longer, too. */
    static final Duration ANSWER_LIMIT = Duration.ofSeconds(1);

    /** Longer than 500 ms: three shorter pulses after power-on would switch the robot to 19200 baud. */
    static final Duration WAKE_PULSE = Duration.ofMillis(700);

    /** A robot in Passive mode falls asleep after five minutes; a pulse a minute keeps it awake. */
    static final Duration KEEP_AWAKE = Duration.ofMinutes(1);

    /** After a change of the baud rate the robot needs 100 ms. */
    static final Duration BAUD_CHANGE = Duration.ofMillis(100);

    private static final Logger LOG = LoggerFactory.getLogger(RoombaSession.class);
    private static final int ATTEMPTS = 3;

    /** A song that claims to have 255 notes. */
    private static final int LONGEST_COMMAND = 3 + 2 * 255;

    private static final int BITS_PER_BYTE = 10;
    private static final long END_LIMIT_MILLIS = 2_000;

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
        /** The robot is told, at the alternate rate, to come back to the usual one; frames do not count. */
        CHANGING_RATE,
        DOWN,
        CLOSED
    }

    private final IntFunction<Link> cable;
    private final Clock clock;
    private final Duration silenceLimit;
    private final Duration answerLimit;
    private final Owner owner;
    private final @Nullable ExecutorService thread;
    private final Executor own;
    private final CompletableFuture<Void> firstAnswer = new CompletableFuture<>();
    private final FirstBytes firstBytes = new FirstBytes();
    private volatile State state = State.NEW;
    private volatile @Nullable Link link;
    private volatile String trouble = "";
    private volatile long lastFrameNanos;
    private boolean alternateTried;
    private int attempt;
    private long askedNanos;
    private long pulsedNanos;
    private long generation;

    Connection(IntFunction<Link> cable, Clock clock, SessionOptions options, Owner owner) {
        this.cable = cable;
        this.clock = clock;
        this.silenceLimit = options.silenceLimit();
        this.answerLimit = longer(ANSWER_LIMIT, silenceLimit.dividedBy(2));
        this.owner = owner;
        this.thread = options.mayWait() ? Executors.newSingleThreadExecutor(Connection::thread) : null;
        this.own = thread != null ? thread : Runnable::run;
    }

    private static Duration longer(Duration one, Duration other) {
        return one.compareTo(other) >= 0 ? one : other;
    }

    private static Thread thread(Runnable work) {
        Thread made = new Thread(work, "roomba-connection");
        made.setDaemon(true);
        return made;
    }

    /** Opens the link for the first time. @throws LinkException if that cannot be done */
    void open() {
        try {
            CompletableFuture.runAsync(
                            () -> {
                                pulsedNanos = clock.nanoTime();
                                plugIn();
                                scheduleLook();
                            },
                            own)
                    .join();
        } catch (CompletionException failure) {
            throw failure.getCause() instanceof RuntimeException cause ? cause : failure;
        }
    }

    /**
     * Completes with the first frame; with a {@link RobotException} if none comes, or a {@link LinkException} if the
     * link is lost or closed before.
     */
    CompletableFuture<Void> firstAnswer() {
        return firstAnswer;
    }

    /** Opens a link and asks the robot for its stream. */
    private void plugIn() {
        plugIn(BAUD, State.ASKING);
        trouble = "no answer yet";
        attempt = 1;
        ask();
    }

    private void plugIn(int baud, State next) {
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
        if (!enter(next)) {
            // Closed meanwhile, by somebody who may not have seen this link.
            fresh.close();
        }
    }

    /** Goes on to a state; false if the connection has been closed, which is for good. */
    private synchronized boolean enter(State next) {
        boolean open = state != State.CLOSED;
        if (open) {
            state = next;
        }
        return open;
    }

    private synchronized boolean enter(State next, State from) {
        return state == from && enter(next);
    }

    private void lose(long ofGeneration, LinkException cause) {
        if (ofGeneration == generation && enter(State.DOWN)) {
            LOG.warn("{}", cause.getMessage());
            trouble = String.valueOf(cause.getMessage());
            firstAnswer.completeExceptionally(cause);
            owner.outOfSight();
        }
    }

    private void ask() {
        if (state != State.ASKING) {
            // It has answered while it was woken; a Start would now end its control.
            return;
        }
        askedNanos = clock.nanoTime();
        Duration pause = MODE_CHANGE;
        if (attempt == 1) {
            trySend(new Command.Start());
        } else {
            completeWhateverIsPending();
            pause = pause.plus(completionTime(BAUD));
        }
        later(pause, () -> {
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

    /** How long the bytes that {@link #completeWhateverIsPending()} sends are on the line. */
    private static Duration completionTime(int baud) {
        return Duration.ofNanos(LONGEST_COMMAND * BITS_PER_BYTE * 1_000_000_000L / baud);
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
        if (enter(State.UP, State.ASKING)) {
            trouble = "";
            firstAnswer.complete(null);
        }
    }

    private void scheduleLook() {
        schedule(LOOK, () -> {
            try {
                look();
            } finally {
                scheduleLook();
            }
        });
    }

    private void look() {
        long now = clock.nanoTime();
        switch (state) {
            case UP -> {
                if (now - lastFrameNanos >= silenceLimit.toNanos()) {
                    fallSilent();
                } else if (now - pulsedNanos >= KEEP_AWAKE.toNanos() && owner.isDozing()) {
                    pulse(() -> {});
                }
            }
            case ASKING -> {
                if (now - askedNanos >= answerLimit.toNanos()) {
                    goOnAsking();
                }
            }
            case DOWN -> replug();
            case NEW, CHANGING_RATE, CLOSED -> {}
        }
    }

    private void fallSilent() {
        if (enter(State.ASKING, State.UP)) {
            LOG.warn("{}: the robot has fallen silent", description());
            trouble = "the robot has fallen silent";
            attempt = 1;
            owner.outOfSight();
            ask();
        }
    }

    private void replug() {
        try {
            plugIn();
        } catch (LinkException stillGone) {
            trouble = String.valueOf(stillGone.getMessage());
            enter(State.DOWN);
            firstAnswer.completeExceptionally(stillGone);
        }
    }

    /** Wakes the robot and asks again; after some attempts tries the other baud rate, at first only once. */
    private void goOnAsking() {
        // The next look must not come here before the question was asked.
        askedNanos = clock.nanoTime() + WAKE_PULSE.toNanos();
        attempt++;
        if (attempt <= ATTEMPTS) {
            pulse(this::ask);
        } else if (!alternateTried) {
            alternateTried = true;
            changeRate();
        } else {
            firstAnswer.completeExceptionally(new RobotException(firstBytes.diagnosis(description())));
            alternateTried = false;
            closeLink();
            replug();
        }
    }

    /** The robot may listen at the alternate rate; then it is told to come back to the usual one. */
    private void changeRate() {
        closeLink();
        try {
            plugIn(ALTERNATE_BAUD, State.CHANGING_RATE);
        } catch (LinkException refused) {
            LOG.debug("{}", refused.getMessage());
            replug();
            return;
        }
        // What it has heard at the wrong rate may have begun any command.
        completeWhateverIsPending();
        later(MODE_CHANGE.plus(completionTime(ALTERNATE_BAUD)), () -> {
            trySend(new Command.Baud(BAUD));
            later(BAUD_CHANGE, () -> {
                closeLink();
                replug();
            });
        });
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

    /** Does some work for the link of this moment; nothing if there is another one by then, or none. */
    private void later(Duration delay, Runnable work) {
        long ofGeneration = generation;
        schedule(delay, () -> {
            if (ofGeneration == generation && state != State.DOWN) {
                work.run();
            }
        });
    }

    private void schedule(Duration delay, Runnable work) {
        if (state == State.CLOSED) {
            return;
        }
        try {
            clock.schedule(delay, () -> run(work));
        } catch (RejectedExecutionException noMoreTime) {
            LOG.debug("too late: the clock is closed");
        }
    }

    private void run(Runnable work) {
        try {
            own.execute(() -> runUnlessClosed(work));
        } catch (RejectedExecutionException closed) {
            LOG.debug("too late: the connection is closed");
        }
    }

    private void runUnlessClosed(Runnable work) {
        if (state != State.CLOSED) {
            try {
                work.run();
            } catch (RuntimeException failure) {
                LOG.error("{}: the connection's own work failed", description(), failure);
            }
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

    /** Closes the link; nothing is sent any more. Waits for the connection's thread. Idempotent. */
    void close() {
        enter(State.CLOSED);
        firstAnswer.completeExceptionally(
                new LinkException(LinkException.Fault.CLOSED, description() + " was closed before the robot answered"));
        Link current = link;
        if (current != null) {
            current.close();
        }
        if (thread != null) {
            thread.shutdown();
            awaitEnd(thread);
        }
    }

    private static void awaitEnd(ExecutorService ending) {
        try {
            if (!ending.awaitTermination(END_LIMIT_MILLIS, TimeUnit.MILLISECONDS)) {
                LOG.warn("thread roomba-connection did not end within {} ms", END_LIMIT_MILLIS);
            }
        } catch (InterruptedException hurry) {
            Thread.currentThread().interrupt();
        }
    }

    /** Ends the link that is to be replaced. */
    private void closeLink() {
        generation++;
        Link current = link;
        if (current != null) {
            current.close();
        }
    }
}
