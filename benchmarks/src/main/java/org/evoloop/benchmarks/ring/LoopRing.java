package org.evoloop.benchmarks.ring;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.concurrent.CountDownLatch;
import org.HdrHistogram.Histogram;
import org.evoloop.loop.Analyze;
import org.evoloop.loop.Execute;
import org.evoloop.loop.Failure;
import org.evoloop.loop.LoopConfig;
import org.evoloop.loop.LoopListener;
import org.evoloop.loop.MapeLoop;
import org.evoloop.loop.Monitor;
import org.evoloop.loop.Plan;
import org.evoloop.time.SystemClock;
import org.jspecify.annotations.Nullable;

/**
 * The framework's loop with components that do nothing: from where the monitor has an occurrence, through analyze, plan
 * and execute, to where the monitor knows that it is done. Four threads, four hand-offs, as in the bare rings.
 */
final class LoopRing {
    private static final Object TOKEN = new Object();
    private static final long LONGEST_NANOS = 10_000_000_000L;

    private final int warmUp;
    private final int rounds;
    private final HandOff back = HandOff.Kind.YIELDING_SLOT.make();
    private final Histogram nanos = new Histogram(LONGEST_NANOS, 3);
    private final CountDownLatch over = new CountDownLatch(1);
    private volatile long allocatedBytes;

    private LoopRing(int warmUp, int rounds) {
        this.warmUp = warmUp;
        this.rounds = rounds;
    }

    /** What was measured: times in nanoseconds, and what all threads of the loop together allocated a round. */
    record Result(Histogram nanos, double bytesPerRound) {}

    static Result run(int warmUp, int rounds) throws InterruptedException {
        LoopRing ring = new LoopRing(warmUp, rounds);
        try (SystemClock clock = new SystemClock();
                MapeLoop<Object, Object, Object> loop =
                        new MapeLoop<>(LoopConfig.defaults("ring", clock), new Quiet())) {
            loop.addMonitor(ring.new Teller());
            loop.addAnalyze(new Nothing());
            loop.addPlan(new Same());
            loop.addExecute(ring.new Done());
            loop.build();
            loop.start();
            ring.over.await();
        }
        return new Result(ring.nanos, ring.allocatedBytes / (double) rounds);
    }

    private static long allocated() {
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        long sum = 0;
        for (long bytes : threads.getThreadAllocatedBytes(threads.getAllThreadIds())) {
            sum += Math.max(0, bytes);
        }
        return sum;
    }

    private final class Teller extends Monitor<Object> {
        private int round = -warmUp;
        private long begun;
        private boolean first = true;
        private long allocatedBefore;

        @Override
        protected @Nullable Object getEvent() throws InterruptedException {
            if (!first) {
                back.take();
                if (round > 0) {
                    nanos.recordValue(System.nanoTime() - begun);
                }
            }
            first = false;
            if (round == 0) {
                allocatedBefore = allocated();
            }
            if (round++ == rounds) {
                allocatedBytes = allocated() - allocatedBefore;
                over.countDown();
                new CountDownLatch(1).await();
            }
            begun = System.nanoTime();
            return TOKEN;
        }
    }

    private static final class Nothing extends Analyze<Object, Object> {
        @Override
        protected Object analyze(Object token) {
            return token;
        }
    }

    private static final class Same extends Plan<Object, Object> {
        @Override
        protected Object plan(Object token) {
            return token;
        }
    }

    private final class Done extends Execute<Object> {
        @Override
        protected void execute(Object token) throws InterruptedException {
            back.give(token);
        }
    }

    private static final class Quiet implements LoopListener<Object> {
        @Override
        public void failed(Failure<Object> failure) {
            throw new IllegalStateException(failure.toString());
        }

        @Override
        public void dropped(Object occurrence, boolean first) {
            throw new IllegalStateException("an occurrence was lost");
        }
    }
}
