package org.evoloop.benchmarks.running;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import org.evoloop.loop.Execute;
import org.evoloop.loop.LoopConfig;
import org.evoloop.loop.MapeLoop;
import org.evoloop.loop.Monitor;
import org.evoloop.time.SystemClock;

/**
 * The framework's loop with four monitors that tell as fast as they can and components that do nothing but look whether
 * each monitor's occurrences come in order. The queue is bounded: what finds it full is lost, and counted.
 */
final class FloodedLoop implements AutoCloseable {
    private static final int MONITORS = 4;

    private final SystemClock clock = new SystemClock();
    private final MapeLoop<Told, Told, Told> loop;
    private final List<Teller> tellers = new ArrayList<>();
    private final long[] last = new long[MONITORS];
    private final CountDownLatch enough = new CountDownLatch(1);
    private final long wanted;
    private long executed;
    private volatile boolean broken;

    /** What a monitor tells. */
    private record Told(int monitor, long number) {}

    FloodedLoop(boolean threads, long wanted) {
        this.wanted = wanted;
        LoopConfig config = LoopConfig.defaults("flood", clock).withQueueCapacity(1024);
        for (int index = 0; index < MONITORS; index++) {
            tellers.add(new Teller(index));
        }
        loop = PlainLoop.build(threads ? config : config.withoutThreads(), true, tellers, new Count());
    }

    /** Events a second, by threads. */
    double byThreads() throws InterruptedException {
        long begun = System.nanoTime();
        loop.start();
        enough.await();
        return finish(System.nanoTime() - begun);
    }

    /** Events a second, in steps: each monitor is asked once, then four steps are taken. */
    double inSteps() throws InterruptedException {
        loop.start();
        long begun = System.nanoTime();
        while (executed < wanted) {
            for (int index = 0; index < MONITORS; index++) {
                loop.observe(tellers.get(index));
            }
            for (int index = 0; index < MONITORS; index++) {
                loop.step();
            }
        }
        return finish(System.nanoTime() - begun);
    }

    private double finish(long nanos) {
        if (broken) {
            throw new IllegalStateException("occurrences of a monitor came out of order");
        }
        return wanted * 1e9 / nanos;
    }

    @Override
    public void close() {
        loop.close();
        clock.close();
    }

    private static final class Teller extends Monitor<Told> {
        private final int index;
        private long number;

        Teller(int index) {
            super("Teller" + index);
            this.index = index;
        }

        @Override
        protected Told getEvent() {
            return new Told(index, ++number);
        }
    }

    private final class Count extends Execute<Told> {
        @Override
        protected void execute(Told told) {
            if (told.number <= last[told.monitor]) {
                broken = true;
            }
            last[told.monitor] = told.number;
            if (++executed == wanted) {
                enough.countDown();
            }
        }
    }
}
