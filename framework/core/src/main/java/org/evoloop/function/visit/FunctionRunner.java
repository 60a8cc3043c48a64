package org.evoloop.function.visit;

import java.time.Duration;
import org.evoloop.function.NewFunction;
import org.evoloop.function.Visit;
import org.evoloop.time.Threads;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Runs the new function of the current visit; there is at most one at a time.
 *
 * <p>Threading: {@link #begin} and {@link #end} are called by one thread at a time; {@link #running} from any.
 */
public final class FunctionRunner {
    private static final Logger LOG = LoggerFactory.getLogger(FunctionRunner.class);

    private final VisitHost host;
    private final Duration joinLimit;
    private volatile @Nullable HostedVisit visit;
    private volatile @Nullable Thread thread;
    private volatile boolean hasFunction;

    /** @param joinLimit how long a function may take to end once it is interrupted, in real time */
    public FunctionRunner(VisitHost host, Duration joinLimit) {
        this.host = host;
        this.joinLimit = joinLimit;
    }

    /** Begins {@code next}, with nothing to run in it. */
    public void begin(HostedVisit next) {
        end();
        visit = next;
    }

    /** Runs {@code function} in the current visit. */
    public void run(NewFunction function) {
        HostedVisit current = visit;
        if (current == null) {
            return;
        }
        hasFunction = true;
        host.notice("***  Start to run new functions. ***");
        if (!host.threads() || function == NewFunction.none()) {
            current.run(function);
            return;
        }
        Thread own = new Thread(() -> current.run(function), "function-" + current.state() + "-" + current.number());
        own.setDaemon(true);
        thread = own;
        own.start();
    }

    /**
     * Ends the current visit and waits for its function. One that does not end in time is left to itself, named in the
     * log; nothing it still raises is heard. Idempotent.
     */
    public void end() {
        HostedVisit ending = visit;
        if (ending == null) {
            return;
        }
        ending.end();
        Thread own = thread;
        if (own != null && !ownsCurrentThread()) {
            own.interrupt();
            if (!Threads.join(own, joinLimit)) {
                LOG.warn(
                        "thread {} did not end within {} ms after {} was left; its function ignores interrupts",
                        own.getName(),
                        joinLimit.toMillis(),
                        ending.state());
            }
        }
        hasFunction = false;
        thread = null;
        visit = null;
    }

    /** Whether the caller is the function's own thread. */
    public boolean ownsCurrentThread() {
        return thread == Thread.currentThread();
    }

    /** The visit whose function runs or has left timers and listeners behind; null if the state needs none. */
    public @Nullable Visit running() {
        return hasFunction ? visit : null;
    }

    /** The name of the function's thread while it is alive, else empty. */
    public String threadName() {
        Thread own = thread;
        return own != null && own.isAlive() ? own.getName() : "";
    }
}
