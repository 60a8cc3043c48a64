package org.evoloop.converter;

import java.time.Duration;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Consumer;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Occurrence;
import org.evoloop.loop.Failure;
import org.evoloop.loop.LoopConfig;
import org.evoloop.time.OwnedThread;
import org.evoloop.time.Threads;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The listeners of a converter, and the thread that calls them. The thread runs while there is a listener.
 *
 * <p>Threading: thread-safe; notifying never waits. When {@value #MOST_WAITING} calls wait, further ones are lost,
 * which is logged.
 */
final class Listeners {
    private static final Logger LOG = LoggerFactory.getLogger(SystemEventConverter.class);
    private static final int MOST_WAITING = 1024;

    /**
     * How long the thread dozes before it waits for a call: so long it need not be woken, which can take the loop longer
     * than a conversion. Short enough that the calls of a flood find room meanwhile.
     */
    private static final long DOZE_NANOS = 250_000;

    private static final long NOT_CONVERTED = -1;

    private final LoopConfig config;
    private final FailureLog failures;
    private final List<ConverterListener> all = new CopyOnWriteArrayList<>();
    private final LinkedBlockingQueue<Consumer<ConverterListener>> waiting = new LinkedBlockingQueue<>(MOST_WAITING);
    private volatile @Nullable Thread thread;

    /** The conversion time of the occurrence in progress; guarded by the lock of the {@link CoreDriver}. */
    private long waitedNanos = NOT_CONVERTED;

    private volatile boolean losing;
    private volatile boolean closed;

    Listeners(LoopConfig config, FailureLog failures) {
        this.config = config;
        this.failures = failures;
    }

    synchronized void add(ConverterListener listener) {
        all.add(listener);
        if (config.threads() && thread == null) {
            Thread notifier = OwnedThread.of(this, "mapek-" + config.name() + "-listeners", this::run);
            thread = notifier;
            notifier.start();
        }
    }

    /** The thread ends when the last one is removed. */
    synchronized void remove(ConverterListener listener) {
        all.remove(listener);
        Thread notifier = thread;
        if (all.isEmpty() && notifier != null) {
            thread = null;
            waiting.clear();
            if (notifier != Thread.currentThread()) {
                notifier.interrupt();
            }
        }
    }

    private void run() {
        try {
            while (!closed && thread == Thread.currentThread()) {
                if (waiting.isEmpty()) {
                    LockSupport.parkNanos(this, DOZE_NANOS);
                }
                call(waiting.take());
                losing = false;
            }
        } catch (InterruptedException stop) {
            // The converter was closed, or there are no listeners any more.
        }
        // What happened before is still reported.
        for (Consumer<ConverterListener> last = closed ? waiting.poll() : null; last != null; last = waiting.poll()) {
            call(last);
        }
    }

    private void call(Consumer<ConverterListener> what) {
        for (ConverterListener listener : all) {
            try {
                what.accept(listener);
            } catch (Throwable cause) {
                String name = nameOf(listener);
                failures.fault("listener " + name, new Failure<>(name, "listener", 0, null, cause));
            }
        }
    }

    private static String nameOf(ConverterListener listener) {
        String simple = listener.getClass().getSimpleName();
        return simple.isEmpty() ? listener.getClass().getName() : simple;
    }

    private void enqueue(Consumer<ConverterListener> what) {
        if (!config.threads()) {
            call(what);
        } else if (!waiting.offer(what) && !losing) {
            losing = true;
            LOG.warn("the listeners of {} are slower than its events; some notices are lost", config.name());
        }
    }

    /** The listeners learn of it when the occurrence ends: waking their thread now would delay the command. */
    void converted(long nanos) {
        waitedNanos = nanos;
    }

    void ended(History history) {
        if (!all.isEmpty()) {
            HistoryEntry entry = history.last();
            // An occurrence dropped meanwhile was not decided.
            long waited = entry.decision() == null ? NOT_CONVERTED : waitedNanos;
            enqueue(listener -> {
                if (waited != NOT_CONVERTED) {
                    listener.converted(Duration.ofNanos(waited));
                }
                listener.ended(entry);
            });
        }
    }

    void moved(Configuration before, Configuration after) {
        if (!all.isEmpty()) {
            enqueue(listener -> listener.moved(before, after));
        }
    }

    void evolved(Evolution.Result result) {
        if (!all.isEmpty()) {
            enqueue(listener -> listener.evolved(result));
        }
    }

    void failed(Failure<Occurrence> failure) {
        if (!all.isEmpty()) {
            enqueue(listener -> listener.failed(failure));
        }
    }

    void doubted(String why) {
        if (!all.isEmpty()) {
            enqueue(listener -> listener.doubted(why));
        }
    }

    /** Whether the caller is a listener. */
    boolean ownsCurrentThread() {
        return OwnedThread.isCurrentOf(this);
    }

    /** Makes the waiting calls and ends the thread. Idempotent; a listener must not call it. */
    void close() {
        Thread notifier;
        synchronized (this) {
            notifier = thread;
        }
        closed = true;
        if (notifier != null) {
            notifier.interrupt();
            if (!Threads.join(notifier, config.joinLimit())) {
                LOG.warn(
                        "thread {} did not end within {} ms; a listener does not return",
                        notifier.getName(),
                        config.joinLimit().toMillis());
            }
        }
    }
}
