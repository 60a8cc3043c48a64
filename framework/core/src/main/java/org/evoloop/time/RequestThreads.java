package org.evoloop.time;

import java.time.Duration;
import java.util.HashMap;
import java.util.Iterator;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.Executor;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.SynchronousQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;

/**
 * The threads of a server, one for each request in progress. Both their number and the time of each request are
 * limited, so that clients that send or read slowly, or not at all, cannot occupy more and more of them. A request whose
 * time is up is interrupted until it ends; if it waits for its channel, that closes the channel.
 *
 * <p>Clients that only begin requests do not lock others out: a request is incomplete until it calls {@link #limit} or
 * {@link #unlimited}, and if no thread is free for another one, the oldest incomplete one is interrupted. A client that
 * sends all of its request at once has been read long before its turn comes.
 *
 * <p>Threading: thread-safe. The threads are daemons; some seconds after the last request there are none.
 *
 * @since 0.1
 */
public final class RequestThreads implements Executor, AutoCloseable {
    private static final int IDLE_SECONDS = 5;
    private static final int LOOK_MILLIS = 500;
    private static final int MOST_IDLE_LOOKS = 10;

    /** How long a request waits for a thread that has given its answer but is not free yet. */
    private static final int HANDOVER_MILLIS = 20;

    /** How long it waits at most for the thread of a request that has been given up, which ends at once. */
    private static final Duration GIVEN_UP = Duration.ofSeconds(1);

    private final String name;
    private final Duration limit;
    private final Clock clock;
    private final ThreadPoolExecutor threads;
    private final Map<Thread, Long> deadlines = new HashMap<>();

    /** The threads of incomplete requests, the oldest first. */
    private final Set<Thread> incomplete = new LinkedHashSet<>();

    private boolean watched;
    private boolean closed;

    /**
     * Creates no thread yet.
     *
     * @param name of each thread; the one that watches the limits is {@code name-limits}
     * @param most requests at a time, at least 1
     * @param limit for a request that sets none
     * @param clock in real time; it stays open
     */
    public RequestThreads(String name, int most, Duration limit, Clock clock) {
        this(name, most, limit, clock, Duration.ofMillis(HANDOVER_MILLIS));
    }

    /** @param handover how long a request waits for a thread, also if none becomes free */
    RequestThreads(String name, int most, Duration limit, Clock clock, Duration handover) {
        this.name = name;
        this.limit = limit;
        this.clock = clock;
        this.threads = new ThreadPoolExecutor(
                0,
                most,
                IDLE_SECONDS,
                TimeUnit.SECONDS,
                new SynchronousQueue<>(),
                task -> Threads.daemon(name, task),
                (request, pool) -> handOver(request, pool, handover));
    }

    private void handOver(Runnable request, ThreadPoolExecutor pool, Duration handover) {
        boolean taken = false;
        long nanos = giveUpOldest() ? GIVEN_UP.toNanos() : handover.toNanos();
        try {
            taken = !pool.isShutdown() && pool.getQueue().offer(request, nanos, TimeUnit.NANOSECONDS);
        } catch (InterruptedException end) {
            Thread.currentThread().interrupt();
        }
        if (!taken) {
            throw new RejectedExecutionException("no thread is free");
        }
    }

    private synchronized boolean giveUpOldest() {
        Iterator<Thread> oldest = incomplete.iterator();
        if (!oldest.hasNext()) {
            return false;
        }
        Thread thread = oldest.next();
        oldest.remove();
        thread.interrupt();
        return true;
    }

    private synchronized void begin() {
        incomplete.add(Thread.currentThread());
        limitFor(limit);
    }

    /**
     * Runs a request. If no thread is free, it waits for {@value #HANDOVER_MILLIS} ms.
     *
     * @throws RejectedExecutionException if there is no thread for it, or this is closed
     */
    @Override
    public void execute(Runnable request) {
        threads.execute(() -> {
            begin();
            try {
                request.run();
            } finally {
                unlimited();
            }
        });
    }

    /** Called by a request: it is complete, and from now on has this much time. */
    public synchronized void limit(Duration time) {
        incomplete.remove(Thread.currentThread());
        forgetInterrupt();
        limitFor(time);
    }

    /** It may have been given up, or its time have been up, just after its last byte: too late to interrupt anything. */
    private void forgetInterrupt() {
        if (!closed) {
            Thread.interrupted();
        }
    }

    private void limitFor(Duration time) {
        deadlines.put(Thread.currentThread(), clock.nanoTime() + time.toNanos());
        if (!watched && !closed) {
            watched = true;
            Threads.start(name + "-limits", this::watch);
        }
    }

    /**
     * Called by a request: it is complete, and until it sets the next limit, it waits for something that its client does
     * not control.
     */
    public synchronized void unlimited() {
        incomplete.remove(Thread.currentThread());
        deadlines.remove(Thread.currentThread());
        forgetInterrupt();
    }

    private synchronized void watch() {
        try {
            for (int idle = 0; idle < MOST_IDLE_LOOKS && !closed; idle = deadlines.isEmpty() ? idle + 1 : 0) {
                long now = clock.nanoTime();
                deadlines.forEach((thread, deadline) -> {
                    if (now - deadline >= 0) {
                        thread.interrupt();
                    }
                });
                wait(LOOK_MILLIS);
            }
        } catch (InterruptedException never) {
            Thread.currentThread().interrupt();
        } finally {
            watched = false;
        }
    }

    /** Interrupts all requests and refuses further ones. Idempotent; does not wait for them. */
    @Override
    public void close() {
        synchronized (this) {
            closed = true;
            notifyAll();
        }
        threads.shutdownNow();
    }
}
