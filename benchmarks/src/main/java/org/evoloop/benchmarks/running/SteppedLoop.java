package org.evoloop.benchmarks.running;

import org.evoloop.loop.Analyze;
import org.evoloop.loop.Execute;
import org.evoloop.loop.Failure;
import org.evoloop.loop.LoopConfig;
import org.evoloop.loop.LoopListener;
import org.evoloop.loop.MapeLoop;
import org.evoloop.loop.Monitor;
import org.evoloop.loop.Plan;
import org.evoloop.time.SystemClock;

/** The framework's loop without threads and with components that do nothing: one cycle is an observation and a step. */
final class SteppedLoop implements AutoCloseable {
    private static final Object TOKEN = new Object();

    private final SystemClock clock = new SystemClock();
    private final MapeLoop<Object, Object, Object> loop;
    private final Monitor<Object> monitor = new Teller();
    private long executed;

    SteppedLoop() {
        loop = new MapeLoop<>(LoopConfig.defaults("step", clock).withoutThreads(), new Quiet());
        loop.addMonitor(monitor);
        loop.addAnalyze(new Same());
        loop.addPlan(new SamePlan());
        loop.addExecute(new Count());
        loop.build();
        loop.start();
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

    private static final class Teller extends Monitor<Object> {
        @Override
        protected Object getEvent() {
            return TOKEN;
        }
    }

    private static final class Same extends Analyze<Object, Object> {
        @Override
        protected Object analyze(Object token) {
            return token;
        }
    }

    private static final class SamePlan extends Plan<Object, Object> {
        @Override
        protected Object plan(Object token) {
            return token;
        }
    }

    private final class Count extends Execute<Object> {
        @Override
        protected void execute(Object token) {
            executed++;
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
