package org.evoloop.function.visit;

import java.time.Duration;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.evoloop.function.NewFunction;
import org.evoloop.function.Visit;
import org.evoloop.time.OwnedThread;
import org.evoloop.time.Threads;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Runs the new function of the current visit; there is at most one at a time.
 *
 * <p>Threading: {@link #begin} and {@link #end} are called by one thread at a time, unless an ending hangs and its
 * thread is left to itself; the other methods by any.
 */
public final class FunctionRunner {
    private static final Logger LOG = LoggerFactory.getLogger(FunctionRunner.class);

    /** No further function begins if more threads than this have been abandoned. */
    private static final int MOST_ABANDONED = 16;

    private final VisitHost host;
    private final Duration joinLimit;
    private volatile @Nullable HostedVisit visit;
    private volatile @Nullable Thread thread;
    private volatile boolean hasFunction;

    /** Abandoned threads. */
    private final List<Thread> abandoned = new CopyOnWriteArrayList<>();

    /** @param joinLimit how long a function may take to end once it is interrupted, in real time */
    public FunctionRunner(VisitHost host, Duration joinLimit) {
        this.host = host;
        this.joinLimit = joinLimit;
    }

    /** Begins {@code next}, without a function. */
    public void begin(HostedVisit next) {
        end();
        visit = next;
    }

    /** Runs {@code function} in the current visit. */
    public void run(NewFunction function) {
        HostedVisit current = visit;
        if (current == null || !isNowRunning(current)) {
            return;
        }
        host.notice("***  Start to run new functions. ***");
        if (!host.threads() || function == NewFunction.none()) {
            current.run(function);
            return;
        }
        abandoned.removeIf(left -> !left.isAlive());
        if (abandoned.size() >= MOST_ABANDONED) {
            host.failed(
                    current,
                    new IllegalStateException("is not started: " + MOST_ABANDONED
                            + " threads of functions that were left have not ended yet, the first is "
                            + abandoned.get(0).getName()));
            return;
        }
        Thread own = OwnedThread.of(
                host, "function-" + current.state() + "-" + current.number(), () -> current.run(function));
        synchronized (this) {
            // If it was left in between, nobody would end the function any more.
            if (current.isActive()) {
                thread = own;
                own.start();
            }
        }
    }

    /** Notes that {@code current} has a function; false if it has been left. */
    private synchronized boolean isNowRunning(HostedVisit current) {
        boolean isPresent = current == visit;
        hasFunction |= isPresent;
        return isPresent;
    }

    /**
     * Ends the current visit and waits for its function. A function that does not end in time is abandoned and named in
     * the log; events that it still raises are ignored. Idempotent.
     */
    public void end() {
        HostedVisit ending = visit;
        if (ending == null) {
            return;
        }
        // First the visit, then its thread: a function that is interrupted must find that it is not active any more.
        ending.end();
        Thread own = threadOf(ending);
        // A function that closes its converter comes here itself, and cannot wait for its own end.
        if (own != null && own != Thread.currentThread()) {
            own.interrupt();
            if (!Threads.join(own, joinLimit)) {
                leftBehind(own, ending);
            }
        }
        Thread hanging = ending.awaitTasks(joinLimit);
        if (hanging != null) {
            leftBehind(hanging, ending);
        }
        synchronized (this) {
            if (ending == visit) {
                hasFunction = false;
                thread = null;
                visit = null;
            }
        }
    }

    /** The thread of the function of {@code ending}; null if its endings took so long that another visit has begun. */
    private synchronized @Nullable Thread threadOf(HostedVisit ending) {
        return ending == visit ? thread : null;
    }

    private void leftBehind(Thread left, HostedVisit ending) {
        abandoned.add(left);
        LOG.warn(
                "thread {} did not end within {} ms after {} was left; its function ignores interrupts",
                left.getName(),
                joinLimit.toMillis(),
                ending.state());
    }

    /** Whether the caller is a thread of a function, or of a loop that a function made. */
    public boolean ownsCurrentThread() {
        return OwnedThread.isCurrentOf(host);
    }

    /** The visit whose function runs or has left timers and listeners behind; null if the state needs none. */
    public @Nullable Visit running() {
        return hasFunction ? visit : null;
    }

    /**
     * The name of the function's thread while it is alive, or of the thread in which one of its tasks hangs; else
     * empty.
     */
    public String threadName() {
        Thread own = thread;
        if (own != null && own.isAlive()) {
            return own.getName();
        }
        HostedVisit current = visit;
        return current == null ? "" : current.hangsIn();
    }
}
