package org.evoloop.benchmarks.running;

import java.util.List;
import org.evoloop.loop.Execute;
import org.evoloop.loop.LoopConfig;
import org.evoloop.loop.MapeLoop;
import org.evoloop.loop.Monitor;
import org.evoloop.time.SystemClock;

/** The framework's loop without threads and with components that do nothing: one cycle is an observation and a step. */
final class SteppedLoop implements AutoCloseable {
    private static final Object TOKEN = new Object();

    private final SystemClock clock = new SystemClock();
    private final MapeLoop<Object, Object, Object> loop;
    private final Monitor<Object> monitor = new Source();
    private long executed;

    SteppedLoop() {
        loop = PlainLoop.build(
                LoopConfig.defaults("step", clock).withoutThreads(), false, List.of(monitor), new Count());
    }

    void cycle() throws InterruptedException {
        loop.observe(monitor);
        loop.step();
    }

    long executed() {
        return executed;
    }

    @Override
    public void close() {
        loop.close();
        clock.close();
    }

    private static final class Source extends Monitor<Object> {
        @Override
        protected Object getEvent() {
            return TOKEN;
        }
    }

    private final class Count extends Execute<Object> {
        @Override
        protected void execute(Object token) {
            executed++;
        }
    }
}
