package org.evoloop.converter.changing;

import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.BooleanSupplier;

/**
 * Serialises changes of a converter. Code that the converter calls must not wait here for a thread that waits for it:
 * its change is refused while the converter is being closed or the calling thread is asked to end.
 *
 * <p>Threading: thread-safe.
 */
final class ChangeLock {
    private static final long LOOK_MILLIS = 20;

    private final String name;
    private final BooleanSupplier fromLoop;
    private final BooleanSupplier fromWithin;
    private final Runnable afterwards;
    private final ReentrantLock lock = new ReentrantLock();
    private volatile boolean closing;

    /**
     * @param name the converter's
     * @param fromLoop whether the caller is a component; every change waits for components
     * @param fromWithin whether the caller is any code that the converter calls
     * @param afterwards runs after each change, when another may be made
     */
    ChangeLock(String name, BooleanSupplier fromLoop, BooleanSupplier fromWithin, Runnable afterwards) {
        this.name = name;
        this.fromLoop = fromLoop;
        this.fromWithin = fromWithin;
        this.afterwards = afterwards;
    }

    /**
     * @throws IllegalStateException if the caller is a component, or the converter is being closed by another thread
     */
    void change(Runnable change) {
        if (fromLoop.getAsBoolean()) {
            throw refused("a converter cannot be changed from its own thread "
                    + Thread.currentThread().getName() + "; hand the change to another thread");
        }
        if (fromWithin.getAsBoolean()) {
            acquireUnlessClosing();
        } else {
            lock.lock();
        }
        runAndRelease(change);
    }

    /** Waits for a change in progress, on any thread, and refuses the changes that wait for their turn. */
    void close(Runnable closing) {
        // Before the lock is taken, so that those who wait for it inside a call of the converter give up.
        this.closing = true;
        lock.lock();
        runAndRelease(closing);
    }

    /** Whether the converter is being closed, or has been. */
    boolean isClosing() {
        return closing;
    }

    private void runAndRelease(Runnable change) {
        try {
            change.run();
        } finally {
            lock.unlock();
            // A change may be made within another one; what runs afterwards may take the lock itself.
            if (!lock.isHeldByCurrentThread()) {
                afterwards.run();
            }
        }
    }

    private void acquireUnlessClosing() {
        try {
            // Not lock(): the thread that closes holds the lock, and may be waiting for this one to end.
            while (!lock.tryLock(LOOK_MILLIS, TimeUnit.MILLISECONDS)) {
                if (closing) {
                    throw refused("it is being closed");
                }
            }
        } catch (InterruptedException interrupted) {
            Thread.currentThread().interrupt();
            throw refused(Thread.currentThread().getName() + " was interrupted");
        }
    }

    private IllegalStateException refused(String why) {
        return new IllegalStateException("the converter " + name + " was not changed: " + why);
    }
}
