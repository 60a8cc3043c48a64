package org.evoloop.converter.running;

import java.time.Duration;
import java.util.concurrent.TimeoutException;
import java.util.function.BooleanSupplier;
import org.evoloop.loop.LoopConfig;
import org.evoloop.time.OwnedThread;
import org.evoloop.time.Threads;

/**
 * Calls a component's hooks while the converter is opened or closed, within a time limit: on a thread that can be
 * abandoned.
 *
 * <p>Threading: {@link #call} by one thread at a time.
 */
final class Hooks {
    private static final Duration LOOK = Duration.ofMillis(50);

    private final LoopConfig config;
    private final BooleanSupplier closing;

    /** @param closing whether no wait may exceed the join limit any more */
    Hooks(LoopConfig config, BooleanSupplier closing) {
        this.config = config;
        this.closing = closing;
    }

    /**
     * Calls {@code task}, which must not throw.
     *
     * @param limit how long it may take before it is interrupted, in real time
     * @return the name of the thread in which it hangs; empty if it has returned
     */
    String call(Duration limit, Runnable task) {
        if (!config.threads()) {
            task.run();
            return "";
        }
        OwnedThread thread = OwnedThread.of(this, "mapek-" + config.name() + "-hook", task);
        thread.start();
        Duration waited = Duration.ZERO;
        Duration inVain = Duration.ZERO;
        while (!Threads.join(thread, LOOK)) {
            waited = waited.plus(LOOK);
            inVain = closing.getAsBoolean() ? inVain.plus(LOOK) : Duration.ZERO;
            if (waited.compareTo(limit) >= 0 || inVain.compareTo(config.joinLimit()) >= 0) {
                thread.interrupt();
                return Threads.join(thread, LOOK) ? "" : thread.getName();
            }
        }
        return "";
    }

    /** For messages. */
    static TimeoutException late(Duration limit, String thread) {
        return new TimeoutException(
                "has not returned for " + limit.toMillis() + " ms, and is abandoned in its thread " + thread);
    }

    /** Whether the caller is such a task. */
    boolean ownsCurrentThread() {
        return OwnedThread.isCurrentOf(this);
    }
}
