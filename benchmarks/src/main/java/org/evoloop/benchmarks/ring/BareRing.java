package org.evoloop.benchmarks.ring;

import org.HdrHistogram.Histogram;
import org.evoloop.benchmarks.report.Latencies;

/** Four threads that only pass an object round: the lower limit for a loop of four threads. */
final class BareRing {
    private static final Object TOKEN = new Object();
    private static final int THREADS = 4;

    private BareRing() {}

    /** The times of {@code rounds} rounds, in nanoseconds, after {@code warmUp} rounds. */
    static Histogram run(HandOff.Kind kind, int warmUp, int rounds) throws InterruptedException {
        HandOff[] hands = new HandOff[THREADS];
        for (int index = 0; index < THREADS; index++) {
            hands[index] = kind.make();
        }
        Thread[] others = new Thread[THREADS - 1];
        for (int index = 0; index < others.length; index++) {
            HandOff from = hands[index];
            HandOff to = hands[index + 1];
            others[index] = new Thread(() -> passOn(from, to), "ring-" + index);
            others[index].setDaemon(true);
            others[index].start();
        }
        Histogram nanos = Latencies.histogram();
        for (int round = -warmUp; round < rounds; round++) {
            long begun = System.nanoTime();
            hands[0].give(TOKEN);
            Object back = hands[THREADS - 1].take();
            if (back != TOKEN) {
                throw new IllegalStateException("something else came round: " + back);
            }
            if (round >= 0) {
                nanos.recordValue(System.nanoTime() - begun);
            }
        }
        for (Thread other : others) {
            other.interrupt();
            other.join();
        }
        return nanos;
    }

    private static void passOn(HandOff from, HandOff to) {
        try {
            while (true) {
                to.give(from.take());
            }
        } catch (InterruptedException over) {
            Thread.currentThread().interrupt();
        }
    }
}
