package org.evoloop.function.visit;

import java.time.Duration;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.evoloop.time.OwnedThread;
import org.evoloop.time.Threads;
import org.jspecify.annotations.Nullable;

/**
 * Runs the scheduled tasks of a function, one after another, on a thread of the visit. The clock waits a moment for
 * each, so that short tasks run in the order of their times; a task that hangs holds up the tasks after it, but not the
 * clock.
 *
 * <p>Threading: thread-safe. The thread is started with the first task.
 */
final class VisitTasks {
    /** How long the clock waits for a task. */
    static final long PATIENCE_MILLIS = 250;

    private final HostedVisit visit;
    private final VisitHost host;
    private final LinkedBlockingQueue<Due> due = new LinkedBlockingQueue<>();
    private @Nullable Thread thread;
    private volatile boolean over;
    private volatile boolean hangs;

    /** @param over counted down when the clock need not wait for it any more */
    private record Due(Runnable task, CountDownLatch over) {}

    VisitTasks(HostedVisit visit, VisitHost host) {
        this.visit = visit;
        this.host = host;
    }

    /** How many tasks are due and have not begun. */
    int waiting() {
        return due.size();
    }

    /** Runs {@code task}, which must not throw; on the clock's thread. */
    void run(Runnable task) {
        Thread own = thread();
        // A task that moves a manual clock is here on its own thread, which would wait for itself.
        if (own == Thread.currentThread()) {
            task.run();
            return;
        }
        CountDownLatch done = new CountDownLatch(1);
        due.add(new Due(task, done));
        if (over) {
            // The state has just been left; nobody may be there to run the task.
            return;
        }
        try {
            if (!hangs && !done.await(PATIENCE_MILLIS, TimeUnit.MILLISECONDS)) {
                hangs = done.getCount() > 0;
                host.failed(
                        visit,
                        new TimeoutException("a task has not returned for " + PATIENCE_MILLIS + " ms in the thread "
                                + own.getName() + "; the tasks after it wait"));
            }
        } catch (InterruptedException stop) {
            Thread.currentThread().interrupt();
        }
    }

    private synchronized Thread thread() {
        Thread own = thread;
        if (own == null) {
            own = OwnedThread.of(host, "function-" + visit.state() + "-" + visit.number() + "-tasks", this::work);
            thread = own;
            own.start();
        }
        return own;
    }

    private void work() {
        while (!over) {
            try {
                Due next = due.take();
                next.task().run();
                hangs = false;
                next.over().countDown();
            } catch (InterruptedException interrupted) {
                // The visit is over, or a task interrupted itself; the condition above distinguishes the two.
            }
        }
        // The clock's thread may be waiting for one of these.
        due.forEach(left -> left.over().countDown());
    }

    /** Prevents further tasks from running, and interrupts the running one. */
    void end() {
        over = true;
        Thread own = own();
        if (own != null && own != Thread.currentThread()) {
            own.interrupt();
        }
    }

    private synchronized @Nullable Thread own() {
        return thread;
    }

    /**
     * After {@link #end}: waits for the running task. Returns its thread if the task does not return in time; else
     * null.
     */
    @Nullable
    Thread awaitEnd(Duration limit) {
        Thread own = own();
        boolean ended = own == null || own == Thread.currentThread() || Threads.join(own, limit);
        return ended ? null : own;
    }

    /** The thread in which a task hangs; empty if none does. */
    String hangsIn() {
        Thread own = own();
        return hangs && own != null ? own.getName() : "";
    }
}
