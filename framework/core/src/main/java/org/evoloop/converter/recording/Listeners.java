package org.evoloop.converter.recording;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Consumer;
import org.evoloop.converter.ConverterListener;
import org.evoloop.converter.Evolution;
import org.evoloop.converter.HistoryEntry;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.converter.running.CoreDriver;
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
 * The listeners of a converter, and the thread that calls them. The thread runs while there is a listener. Without
 * threads, calls wait until the converter has taken its step: a listener may use the converter, whose core must not be
 * given an input while it says what follows from another.
 *
 * <p>Threading: thread-safe; notifying never waits. When {@value #MOST_WAITING} calls wait for the thread, further ones
 * are lost, which is logged.
 */
public final class Listeners {
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

    /** Replaced as a whole, so that a notice can keep those that were there when it was made. */
    private volatile List<ConverterListener> all = List.of();

    /** The calls that wait, with their thread; null if there is no listener. */
    private volatile @Nullable Calls calls;

    /** Whether a thread is delivering calls in a converter without threads. */
    private final AtomicBoolean delivering = new AtomicBoolean();

    /** The conversion time of the occurrence in progress; guarded by the lock of the {@link CoreDriver}. */
    private long waitedNanos = NOT_CONVERTED;

    private final AwaitedEndings endings;

    private volatile boolean losing;
    private volatile boolean closed;

    public Listeners(LoopConfig config, FailureLog failures) {
        this.config = config;
        this.failures = failures;
        this.endings = new AwaitedEndings(config.threads());
    }

    /** Those who wait for the end of one occurrence. */
    public AwaitedEndings endings() {
        return endings;
    }

    /** A call of {@code to}, the listeners when it was made. */
    private record Notice(List<ConverterListener> to, Consumer<ConverterListener> what) {
        static final Notice LAST = new Notice(List.of(), listener -> {});

        /** Whether the thread ends, since there is nobody to call. */
        boolean isLast() {
            return to.isEmpty();
        }
    }

    /** Calls that wait, and the thread that makes them, if there are threads. */
    private final class Calls {
        final LinkedBlockingQueue<Notice> waiting =
                new LinkedBlockingQueue<>(config.threads() ? MOST_WAITING : Integer.MAX_VALUE);
        final Thread thread = OwnedThread.of(Listeners.this, "mapek-" + config.name() + "-listeners", this::run);

        private void run() {
            boolean goesOn = true;
            while (goesOn) {
                try {
                    Notice next = take();
                    call(next);
                    losing = false;
                    goesOn = !next.isLast();
                } catch (InterruptedException interrupted) {
                    // Either by a listener that interrupted its own thread, or because one did not return in time when
                    // the converter was closed.
                    goesOn = !closed;
                }
            }
        }

        private Notice take() throws InterruptedException {
            if (waiting.isEmpty() && !closed) {
                LockSupport.parkNanos(this, DOZE_NANOS);
            }
            Notice next = closed ? waiting.poll() : waiting.take();
            return next == null ? Notice.LAST : next;
        }

        /** Ends the thread after the calls that wait. */
        void end() {
            // If there is no room, the thread is not waiting for a call.
            waiting.offer(Notice.LAST);
        }
    }

    public synchronized void add(ConverterListener listener) {
        List<ConverterListener> more = new ArrayList<>(all);
        more.add(listener);
        if (calls == null) {
            Calls begun = new Calls();
            calls = begun;
            if (config.threads()) {
                begun.thread.start();
            }
        }
        all = List.copyOf(more);
    }

    /** The thread ends when the last one is removed. */
    public synchronized void remove(ConverterListener listener) {
        List<ConverterListener> fewer = new ArrayList<>(all);
        fewer.remove(listener);
        all = List.copyOf(fewer);
        Calls ending = calls;
        if (fewer.isEmpty() && ending != null) {
            calls = null;
            // A call in progress completes; the others are for nobody.
            ending.waiting.clear();
            ending.end();
        }
    }

    private void call(Notice notice) {
        for (ConverterListener listener : notice.to()) {
            if (all.contains(listener)) {
                call(listener, notice.what());
            }
        }
    }

    private void call(ConverterListener listener, Consumer<ConverterListener> what) {
        try {
            what.accept(listener);
        } catch (Throwable cause) {
            String name = nameOf(listener);
            failures.note("listener " + name, new Failure<>(name, "listener", 0, null, cause));
        }
    }

    private static String nameOf(ConverterListener listener) {
        String simple = listener.getClass().getSimpleName();
        return simple.isEmpty() ? listener.getClass().getName() : simple;
    }

    private void enqueue(Consumer<ConverterListener> what) {
        Calls present = calls;
        if (present != null && !present.waiting.offer(new Notice(all, what)) && !losing) {
            losing = true;
            LOG.warn("the listeners of {} are slower than its events; some notices are lost", config.name());
        }
    }

    /**
     * Makes the calls that wait, in a converter without threads, on the caller's thread: after a step, and not while
     * another call is made.
     */
    public void deliver() {
        endings.deliver();
        while (!config.threads() && hasCalls() && delivering.compareAndSet(false, true)) {
            try {
                for (Notice next = poll(); next != null; next = poll()) {
                    call(next);
                }
            } finally {
                delivering.set(false);
            }
        }
    }

    private boolean hasCalls() {
        Calls present = calls;
        return present != null && !present.waiting.isEmpty();
    }

    private @Nullable Notice poll() {
        Calls present = calls;
        return present == null ? null : present.waiting.poll();
    }

    /** The listeners learn of it when the occurrence ends: waking their thread now would delay the command. */
    public void converted(long nanos) {
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

    public void moved(Configuration before, Configuration after) {
        if (!all.isEmpty()) {
            enqueue(listener -> listener.moved(before, after));
        }
    }

    public void evolved(Evolution.Result result) {
        if (!all.isEmpty()) {
            enqueue(listener -> listener.evolved(result));
        }
    }

    public void failed(Failure<Occurrence> failure) {
        if (!all.isEmpty()) {
            enqueue(listener -> listener.failed(failure));
        }
    }

    public void doubted(String why) {
        if (!all.isEmpty()) {
            enqueue(listener -> listener.doubted(why));
        }
    }

    /** Whether the caller is a listener. */
    public boolean ownsCurrentThread() {
        return OwnedThread.isCurrentOf(this);
    }

    /** Makes the waiting calls and ends the thread. Idempotent; a listener must not call it. */
    public void close() {
        endings.close();
        deliver();
        closed = true;
        Calls ending = calls;
        if (ending == null || !config.threads()) {
            return;
        }
        ending.end();
        if (!Threads.join(ending.thread, config.joinLimit())) {
            ending.thread.interrupt();
            LOG.warn(
                    "thread {} did not end within {} ms; a listener does not return",
                    ending.thread.getName(),
                    config.joinLimit().toMillis());
        }
    }
}
