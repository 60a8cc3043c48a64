package org.evoloop.benchmarks.ring;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import org.HdrHistogram.Histogram;
import org.evoloop.benchmarks.report.Latencies;
import org.evoloop.benchmarks.running.PlainLoop;
import org.evoloop.loop.Execute;
import org.evoloop.loop.MapeLoop;
import org.evoloop.loop.Monitor;
import org.evoloop.time.SystemClock;
import org.jspecify.annotations.Nullable;

/**
 * The framework's loop with components that do nothing. The time runs from a monitor having an event, through analyze,
 * plan and execute, to the monitor learning that it is done. Four threads, four hand-offs, as in the bare rings.
 */
final class LoopRing {
    private static final Object TOKEN = new Object();

    private final int warmUp;
    private final int rounds;
    private final HandOff back = HandOff.Kind.YIELDING_SLOT.make();
    private final Histogram nanos = Latencies.histogram();
    private final CountDownLatch over = new CountDownLatch(1);
    private volatile long allocatedBytes;

    private LoopRing(int warmUp, int rounds) {
        this.warmUp = warmUp;
        this.rounds = rounds;
    }

    /** The results: times in nanoseconds, and the allocation of all the loop's threads per round. */
    record Result(Histogram nanos, double bytesPerRound) {}

    @SuppressWarnings("try") // it only has to be closed
    static Result run(int warmUp, int rounds) throws InterruptedException {
        LoopRing ring = new LoopRing(warmUp, rounds);
        try (SystemClock clock = new SystemClock();
                MapeLoop<Object, Object, Object> loop = PlainLoop.build(
                        PlainLoop.threads("ring", clock), false, List.of(ring.new Source()), ring.new Done())) {
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

    private final class Source extends Monitor<Object> {
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

    private final class Done extends Execute<Object> {
        @Override
        protected void execute(Object token) throws InterruptedException {
            back.give(token);
        }
    }
}
