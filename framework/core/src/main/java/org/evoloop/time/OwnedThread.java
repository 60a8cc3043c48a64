package org.evoloop.time;

import java.util.HashSet;
import java.util.Set;

/**
 * A daemon thread with an owner. Code on this thread must not wait for its owner, which may be waiting for the thread
 * to end.
 *
 * <p>Threading: immutable but for what {@link Thread} is.
 *
 * @since 0.1
 */
public final class OwnedThread extends Thread {
    private final Set<Object> owners;

    private OwnedThread(Set<Object> owners, String name, Runnable task) {
        super(task, name);
        this.owners = owners;
        // Code that cannot be stopped must not keep the program alive.
        setDaemon(true);
    }

    /** A thread that works for {@code owner} alone. */
    public static OwnedThread of(Object owner, String name, Runnable task) {
        return new OwnedThread(Set.of(owner), name, task);
    }

    /** A thread that also works for all owners of the caller's thread, since they wait for {@code owner} to end. */
    public static OwnedThread within(Object owner, String name, Runnable task) {
        Set<Object> owners = new HashSet<>();
        owners.add(owner);
        if (Thread.currentThread() instanceof OwnedThread outer) {
            owners.addAll(outer.owners);
        }
        return new OwnedThread(Set.copyOf(owners), name, task);
    }

    /** Whether the caller's thread works for {@code owner}, which is compared by identity. */
    public static boolean isCurrentOf(Object owner) {
        if (Thread.currentThread() instanceof OwnedThread current) {
            for (Object one : current.owners) {
                if (one == owner) {
                    return true;
                }
            }
        }
        return false;
    }
}
