package org.evoloop.loop;

import java.util.Locale;
import java.util.concurrent.atomic.AtomicLong;
import org.jspecify.annotations.Nullable;

/** One component in the loop: its thread and its status. */
abstract class Worker {
    private final Component component;
    private final AtomicLong failures = new AtomicLong();
    private volatile String lastFailure = "";

    Worker(Component component) {
        this.component = component;
    }

    final Component component() {
        return component;
    }

    /** Its role in the loop: {@code monitor}, {@code analyze}, {@code plan} or {@code execute}. */
    final String roleName() {
        return component.role().name().toLowerCase(Locale.ROOT);
    }

    /** The thread that calls the component; null if the loop has no threads. */
    abstract @Nullable LoopThread thread();

    /** The thread that calls only this component; null if there is none. */
    abstract @Nullable LoopThread ownThread();

    /** The thread that ends when the component leaves the loop; null if none does. */
    @Nullable
    LoopThread threadToEnd() {
        return ownThread();
    }

    abstract boolean isWorking();

    abstract boolean isStuck();

    /** Starts its own thread. */
    final void start() {
        LoopThread own = ownThread();
        if (own != null) {
            own.start();
        }
    }

    /** Ends its own thread. */
    final void retire() {
        LoopThread own = threadToEnd();
        if (own != null) {
            own.retire();
        }
    }

    final void countFailure(String message) {
        lastFailure = message;
        failures.incrementAndGet();
    }

    final String threadName() {
        LoopThread known = thread();
        return known == null ? "" : known.name();
    }

    final ComponentStatus status() {
        LoopThread known = thread();
        ComponentStatus.Activity activity = known == null || !known.isAlive()
                ? ComponentStatus.Activity.ENDED
                : isStuck()
                        ? ComponentStatus.Activity.STUCK
                        : isWorking() ? ComponentStatus.Activity.WORKING : ComponentStatus.Activity.WAITING;
        return new ComponentStatus(
                component.name(),
                component.role(),
                known == null ? "" : known.name(),
                activity,
                failures.get(),
                lastFailure);
    }
}
