package org.evoloop.journal;

import java.time.Duration;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.locks.LockSupport;
import org.evoloop.time.Threads;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Forces written data to the disk, every {@value #PERIOD_MILLIS} ms while there is any, and does the work for which no
 * event has to wait, such as closing segments and deleting files. It sleeps when nothing was written for {@value
 * #AWAKE_PERIODS} periods, so that events rarely have to wake it.
 */
final class Forcer implements AutoCloseable {
    static final int PERIOD_MILLIS = 100;
    private static final int AWAKE_PERIODS = 20;
    private static final Logger LOG = LoggerFactory.getLogger(Journal.class);

    private final Thread thread;
    private volatile @Nullable Segment segment;
    private final Queue<Runnable> chores = new ConcurrentLinkedQueue<>();
    private volatile boolean asleep;
    private volatile boolean closed;

    Forcer(String name) {
        thread = new Thread(this::run, "journal-" + name);
        thread.setDaemon(true);
        thread.start();
    }

    /**
     * Sets the segment that is written from now on.
     *
     * @param chore the work left for the previous segments
     */
    void use(Segment next, Runnable chore) {
        segment = next;
        chores.add(chore);
        wake();
    }

    /** Something was written. */
    void written() {
        if (asleep) {
            wake();
        }
    }

    private void wake() {
        asleep = false;
        LockSupport.unpark(thread);
    }

    private void run() {
        int idle = 0;
        while (!closed) {
            LockSupport.parkNanos(this, Duration.ofMillis(PERIOD_MILLIS).toNanos());
            idle = force() ? 0 : idle + 1;
            if (idle >= AWAKE_PERIODS) {
                sleep();
                idle = 0;
            }
        }
    }

    private void sleep() {
        asleep = true;
        // A write before the flag was set woke no thread, so everything is checked again.
        while (asleep && !closed && chores.isEmpty() && !isDirty()) {
            LockSupport.park(this);
        }
        asleep = false;
    }

    private boolean isDirty() {
        Segment current = segment;
        return current != null && current.isDirty();
    }

    private boolean force() {
        try {
            doChores();
            Segment current = segment;
            if (current == null || !current.isDirty()) {
                return false;
            }
            current.look();
            if (!current.isLost()) {
                current.force();
            }
        } catch (RuntimeException | InternalError e) {
            LOG.warn("a journal cannot be put on the disk; a power cut would lose what was written", e);
        }
        return true;
    }

    private void doChores() {
        for (Runnable chore = chores.poll(); chore != null; chore = chores.poll()) {
            chore.run();
        }
    }

    @Override
    public void close() {
        closed = true;
        LockSupport.unpark(thread);
        Threads.join(thread, Duration.ofSeconds(2));
        doChores();
    }
}
