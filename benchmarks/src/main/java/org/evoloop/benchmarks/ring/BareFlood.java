package org.evoloop.benchmarks.ring;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import org.evoloop.benchmarks.running.Flood;
import org.evoloop.time.SystemClock;

/**
 * Only a ring of three threads in a {@link Flood}. Monitors push into a bounded queue and drop events when it is full.
 * The first thread takes an event from the queue; the third executes it and lets the first continue. As in the loop,
 * one event is in progress at a time.
 */
final class BareFlood {
    private static final int STAGES = 3;

    private final Flood flood = new Flood();
    // The JDK's queue that refuses without a lock, as the loop's queue does.
    private final BlockingQueue<Flood.NumberedEvent> queue = new LinkedBlockingQueue<>(Flood.CAPACITY);
    private final HandOff[] hands = new HandOff[STAGES];
    private final List<Thread> threads = new ArrayList<>();

    private BareFlood(HandOff.Kind kind) {
        for (int index = 0; index < STAGES; index++) {
            hands[index] = kind.make();
        }
    }

    /** A thread's work, ended by an interrupt. */
    private interface Work {
        void run() throws InterruptedException;
    }

    /** Events per second, after a warm-up. */
    static double rate(HandOff.Kind kind, Duration warmUp, Duration watched) throws InterruptedException {
        BareFlood bare = new BareFlood(kind);
        bare.start();
        try (SystemClock clock = new SystemClock()) {
            return bare.flood.rate(clock, warmUp, watched);
        } finally {
            bare.stop();
        }
    }

    private void start() {
        begin("first", this::first);
        begin("second", () -> hands[1].give(hands[0].take()));
        begin("third", this::third);
        for (int index = 0; index < Flood.MONITORS; index++) {
            int monitor = index;
            long[] number = {0};
            begin("monitor-" + monitor, () -> report(new Flood.NumberedEvent(monitor, ++number[0])));
        }
    }

    @SuppressWarnings("ThreadPriorityCheck") // else monitors would take all processors, and the ring would starve
    private void report(Flood.NumberedEvent event) {
        if (!queue.offer(event)) {
            Thread.yield();
        }
    }

    private void first() throws InterruptedException {
        hands[0].give(queue.take());
        hands[2].take();
    }

    private void third() throws InterruptedException {
        Object event = hands[1].take();
        flood.execute((Flood.NumberedEvent) event);
        hands[2].give(event);
    }

    private void begin(String name, Work work) {
        Thread thread = new Thread(() -> repeat(work), "flood-" + name);
        thread.setDaemon(true);
        threads.add(thread);
        thread.start();
    }

    private static void repeat(Work work) {
        try {
            while (!Thread.currentThread().isInterrupted()) {
                work.run();
            }
        } catch (InterruptedException over) {
            Thread.currentThread().interrupt();
        }
    }

    private void stop() throws InterruptedException {
        threads.forEach(Thread::interrupt);
        for (Thread thread : threads) {
            thread.join();
        }
    }
}
