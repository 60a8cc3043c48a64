package org.evoloop.benchmarks.running;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.evoloop.loop.Execute;
import org.evoloop.loop.LoopConfig;
import org.evoloop.loop.MapeLoop;
import org.evoloop.loop.Monitor;
import org.evoloop.time.SystemClock;

/** The framework's loop in a {@link Flood}, with components that do nothing. */
public final class FloodedLoop implements AutoCloseable {
    private final SystemClock clock = new SystemClock();
    private final MapeLoop<Flood.NumberedEvent, Flood.NumberedEvent, Flood.NumberedEvent> loop;
    private final List<Source> sources = new ArrayList<>();
    private final Flood flood = new Flood();

    public FloodedLoop(boolean threads) {
        LoopConfig config = PlainLoop.threads("flood", clock).withQueueCapacity(Flood.CAPACITY);
        for (int index = 0; index < Flood.MONITORS; index++) {
            sources.add(new Source(index));
        }
        loop = PlainLoop.build(threads ? config : config.withoutThreads(), true, sources, new Count());
    }

    /** Events per second with threads, after a warm-up. */
    public double byThreads(Duration warmUp, Duration watched) throws InterruptedException {
        return flood.rate(clock, warmUp, watched);
    }

    /**
     * Events per second in steps, over {@code wanted} events: each monitor is asked once, then four steps are taken.
     */
    double inSteps(long wanted) throws InterruptedException {
        long begun = System.nanoTime();
        while (flood.executed() < wanted) {
            for (Source source : sources) {
                loop.observe(source);
            }
            for (int index = 0; index < Flood.MONITORS; index++) {
                loop.step();
            }
        }
        long nanos = System.nanoTime() - begun;
        flood.requireOrder();
        return wanted * 1e9 / nanos;
    }

    @Override
    public void close() {
        loop.close();
        clock.close();
    }

    private static final class Source extends Monitor<Flood.NumberedEvent> {
        private final int index;
        private long number;

        Source(int index) {
            super("Teller" + index);
            this.index = index;
        }

        @Override
        protected Flood.NumberedEvent getEvent() {
            return new Flood.NumberedEvent(index, ++number);
        }
    }

    private final class Count extends Execute<Flood.NumberedEvent> {
        @Override
        protected void execute(Flood.NumberedEvent event) {
            flood.execute(event);
        }
    }
}
