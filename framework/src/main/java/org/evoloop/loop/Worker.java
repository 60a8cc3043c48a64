package org.evoloop.loop;

import java.time.Duration;
import java.util.Locale;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.locks.LockSupport;
import org.jspecify.annotations.Nullable;

/** The thread of one component, and how the component fares. */
abstract class Worker implements Runnable {
    private static final long RETURN_NANOS = 50_000_000;

    private final Component component;
    private final @Nullable Thread thread;
    private final AtomicLong failures = new AtomicLong();
    private volatile String lastFailure = "";
    private volatile boolean retired;
    private volatile boolean stuck;

    Worker(Component component, LoopConfig config) {
        this.component = component;
        this.thread = config.threads()
                ? new Thread(this, "mapek-" + config.name() + "-" + roleName() + "-" + component.name())
                : null;
        if (thread != null) {
            // A component that cannot be stopped must not keep the program alive.
            thread.setDaemon(true);
        }
    }

    /** Its place in the loop: {@code monitor}, {@code analyze}, {@code plan} or {@code execute}. */
    final String roleName() {
        return component.role().name().toLowerCase(Locale.ROOT);
    }

    /** One round on the component's thread; returns when it is time to look whether the thread is still wanted. */
    abstract void work() throws InterruptedException;

    abstract boolean isWorking();

    @Override
    public final void run() {
        while (!retired) {
            try {
                work();
            } catch (InterruptedException stop) {
                // Whoever interrupts a worker retires it or gives its work up; the condition above tells which.
                setStuck(false);
            }
        }
    }

    @SuppressWarnings("ThreadPriorityCheck") // a hint only: nothing is wrong if the scheduler ignores it
    static void giveWay() {
        Thread.yield();
    }

    final Component component() {
        return component;
    }

    final boolean hasThread() {
        return thread != null;
    }

    final void start() {
        if (thread != null) {
            thread.start();
        }
    }

    final void interrupt() {
        if (thread != null) {
            thread.interrupt();
        }
    }

    final void unpark() {
        LockSupport.unpark(thread);
    }

    final boolean isRetired() {
        return retired;
    }

    final void retire() {
        retired = true;
        interrupt();
    }

    /**
     * Waits for the thread to end. An interrupt of the caller does not cut the wait short; its flag is restored.
     *
     * @return whether it has ended, or there is none to wait for
     */
    final boolean join(Duration limit) {
        return thread == null || ownsCurrentThread() || Threads.join(thread, limit);
    }

    final boolean ownsCurrentThread() {
        return thread == Thread.currentThread();
    }

    /** Gives a component that was interrupted a moment to return, so that what comes next does not find it stuck. */
    final void letReturn() {
        long deadline = System.nanoTime() + RETURN_NANOS;
        while (thread != null && stuck && System.nanoTime() < deadline) {
            giveWay();
        }
    }

    final boolean isStuck() {
        return stuck;
    }

    final void setStuck(boolean nowStuck) {
        stuck = nowStuck;
    }

    final void countFailure(String message) {
        lastFailure = message;
        failures.incrementAndGet();
    }

    final String threadName() {
        return thread == null ? "" : thread.getName();
    }

    final ComponentStatus status() {
        ComponentStatus.Activity activity = thread == null || !thread.isAlive()
                ? ComponentStatus.Activity.ENDED
                : stuck
                        ? ComponentStatus.Activity.STUCK
                        : isWorking() ? ComponentStatus.Activity.WORKING : ComponentStatus.Activity.WAITING;
        return new ComponentStatus(
                component.name(), component.role(), threadName(), activity, failures.get(), lastFailure);
    }
}
