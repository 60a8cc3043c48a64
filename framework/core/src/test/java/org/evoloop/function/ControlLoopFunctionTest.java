package org.evoloop.function;

import static org.assertj.core.api.Assertions.assertThat;
import static org.evoloop.function.visit.VisitLog.take;

import java.time.Duration;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import org.evoloop.function.visit.FunctionRunner;
import org.evoloop.function.visit.HostedVisit;
import org.evoloop.function.visit.VisitLog;
import org.evoloop.loop.Analyze;
import org.evoloop.loop.Execute;
import org.evoloop.loop.LoopState;
import org.evoloop.loop.MapeLoop;
import org.evoloop.loop.Monitor;
import org.evoloop.loop.Plan;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** A function with its own control loop: it counts down and finishes at zero. */
@Timeout(60)
class ControlLoopFunctionTest {
    private final BlockingQueue<Integer> counts = new LinkedBlockingQueue<>();
    private final BlockingQueue<MapeLoop<Integer, Integer, Integer>> loops = new LinkedBlockingQueue<>();
    private final BlockingQueue<String> done = new LinkedBlockingQueue<>();

    private class Countdown extends ControlLoopFunction<Integer, Integer, Integer> {
        final Monitor<Integer> monitor = new Monitor<>("Ticks") {
            @Override
            protected @Nullable Integer getEvent() throws InterruptedException {
                return ticking ? counts.take() : counts.poll();
            }
        };
        private final boolean ticking;

        Countdown(boolean ticking) {
            this.ticking = ticking;
        }

        @Override
        protected void assemble(MapeLoop<Integer, Integer, Integer> loop, Visit visit) throws Exception {
            loop.addMonitor(monitor);
            loop.addAnalyze(new Analyze<>("Same") {
                @Override
                protected Integer analyze(Integer count) {
                    return count;
                }
            });
            loop.addPlan(new Plan<>("Less") {
                @Override
                protected @Nullable Integer plan(Integer count) {
                    if (count < 0) {
                        throw new IllegalArgumentException("below zero");
                    }
                    return count;
                }
            });
            loop.addExecute(new Execute<>("Say") {
                @Override
                protected void execute(Integer count) {
                    done.add("at " + count + (visit.isActive() ? "" : ", too late"));
                    if (count == 0) {
                        visit.finish("arriveSpot");
                    }
                }
            });
            visit.onEnd(() -> done.add("cleaned up"));
            loops.add(loop);
        }
    }

    @Test
    void finishesFromWithinItsLoopWhichIsClosedWhenTheStateIsLeft() throws InterruptedException {
        VisitLog log = new VisitLog(true);
        FunctionRunner runner = new FunctionRunner(log, Duration.ofSeconds(2));
        runner.begin(log.visit());
        runner.run(new Countdown(true));
        MapeLoop<Integer, Integer, Integer> loop = take(loops);
        counts.add(1);
        assertThat(take(done)).isEqualTo("at 1");
        counts.add(-1);
        counts.add(0);
        assertThat(take(done)).isEqualTo("at 0");
        assertThat(take(log.events)).isEqualTo("finished arriveSpot");
        assertThat(loop.state()).as("until the state is left").isEqualTo(LoopState.RUNNING);

        runner.end();
        assertThat(loop.state()).isEqualTo(LoopState.EXITED);
        assertThat(done).as("after the loop").containsExactly("cleaned up");
        assertThat(Thread.getAllStackTraces().keySet())
                .extracting(Thread::getName)
                .noneMatch(name -> name.startsWith("mapek-Move-"));
        assertThat(log.failures)
                .as("failures that its loop survives are not reported")
                .isEmpty();
    }

    @Test
    void everyVisitHasALoopOfItsOwn() throws InterruptedException {
        VisitLog log = new VisitLog(true);
        FunctionRunner runner = new FunctionRunner(log, Duration.ofSeconds(2));
        for (int visits = 0; visits < 2; visits++) {
            Countdown countdown = new Countdown(true);
            runner.begin(log.visit());
            runner.run(countdown);
            counts.add(5);
            assertThat(take(done)).isEqualTo("at 5");
            runner.end();
            assertThat(take(done)).isEqualTo("cleaned up");
        }
        assertThat(loops).hasSize(2).doesNotHaveDuplicates();
    }

    @Test
    void takesStepsInAConverterWithoutThreads() throws InterruptedException {
        VisitLog log = new VisitLog(false);
        FunctionRunner runner = new FunctionRunner(log, Duration.ofSeconds(2));
        Countdown countdown = new Countdown(false);
        runner.begin(log.visit());
        runner.run(countdown);
        MapeLoop<Integer, Integer, Integer> loop = take(loops);
        counts.add(0);
        loop.observe(countdown.monitor);
        assertThat(done).isEmpty();
        assertThat(loop.step()).isTrue();
        assertThat(done).containsExactly("at 0");
        assertThat(log.events).containsExactly("finished arriveSpot");
        runner.end();
        assertThat(loop.state()).isEqualTo(LoopState.EXITED);
        assertThat(loop.offer(0)).isFalse();
    }

    @Test
    void aStateThatIsLeftWhileItsLoopIsBeingBuiltIsNoFailure() throws InterruptedException {
        VisitLog log = new VisitLog(true);
        FunctionRunner runner = new FunctionRunner(log, Duration.ofSeconds(20));
        CountDownLatch assembling = new CountDownLatch(1);
        HostedVisit visit = log.visit();
        runner.begin(visit);
        runner.run(new Countdown(true) {
            @Override
            protected void assemble(MapeLoop<Integer, Integer, Integer> loop, Visit visited) throws Exception {
                super.assemble(loop, visited);
                assembling.countDown();
                while (visited.isActive()) {
                    Thread.onSpinWait();
                }
            }
        });
        assembling.await();
        runner.end();
        assertThat(log.failures).isEmpty();
        assertThat(take(loops).state()).isEqualTo(LoopState.EXITED);
        assertThat(Thread.getAllStackTraces().keySet())
                .extracting(Thread::getName)
                .noneMatch(name -> name.startsWith("mapek-Move-"));
    }

    @Test
    void aLoopThatLacksAComponentIsReported() throws InterruptedException {
        VisitLog log = new VisitLog(true);
        FunctionRunner runner = new FunctionRunner(log, Duration.ofSeconds(2));
        runner.begin(log.visit());
        runner.run(new ControlLoopFunction<String, String, String>() {
            @Override
            protected void assemble(MapeLoop<String, String, String> loop, Visit visit) {}
        });
        assertThat(take(log.failures))
                .hasMessage("loop Move: no analyze component, exactly 1 is needed; no plan component, exactly 1 is "
                        + "needed; no execute component, at least 1 is needed");
        runner.end();
    }
}
