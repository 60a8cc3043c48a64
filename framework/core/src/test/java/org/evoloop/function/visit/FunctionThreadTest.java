package org.evoloop.function.visit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.evoloop.function.visit.VisitLog.take;

import java.time.Duration;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** A function's own thread. */
@Timeout(60)
class FunctionThreadTest {
    private final VisitLog log = new VisitLog(true);
    private final FunctionRunner runner = new FunctionRunner(log, Duration.ofMillis(50));
    private final BlockingQueue<Thread> threads = new LinkedBlockingQueue<>();

    @Test
    void isNamedAfterItsVisitAndEndsWithIt() throws InterruptedException {
        BlockingQueue<String> fates = new LinkedBlockingQueue<>();
        // It is waited for as long as it takes.
        FunctionRunner patient = new FunctionRunner(log, Duration.ofSeconds(30));
        HostedVisit visit = log.visit();
        patient.begin(visit);
        assertThat(patient.running()).isNull();
        patient.run(running -> {
            threads.add(Thread.currentThread());
            try {
                running.sleep(Duration.ofHours(1));
            } catch (InterruptedException left) {
                fates.add(running.isActive() ? "interrupted too early" : "interrupted");
                throw left;
            }
        });
        Thread thread = take(threads);
        assertThat(thread.getName()).isEqualTo("function-Move-1").isEqualTo(patient.threadName());
        assertThat(thread.isDaemon()).isTrue();
        assertThat(patient.running()).isSameAs(visit);

        patient.end();
        patient.end();
        assertThat(take(fates)).isEqualTo("interrupted");
        assertThat(thread.isAlive()).isFalse();
        assertThat(patient.running()).isNull();
        assertThat(patient.threadName()).isEmpty();
        assertThat(log.failures).isEmpty();
        assertThat(log.clock.pendingTasks()).isZero();
    }

    @Test
    void isLeftBehindIfItIgnoresInterruptsAndHasNothingMoreToSay() throws InterruptedException {
        CountDownLatch atLast = new CountDownLatch(1);
        runner.begin(log.visit());
        runner.run(running -> {
            threads.add(Thread.currentThread());
            boolean interrupted = false;
            while (atLast.getCount() > 0) {
                try {
                    atLast.await();
                } catch (InterruptedException ignored) {
                    interrupted = true;
                }
            }
            running.raise("halfway");
            running.finish(interrupted ? "arriveSpot" : "timeout");
        });
        Thread deaf = take(threads);
        runner.begin(log.visit());
        assertThat(deaf.isAlive()).isTrue();
        assertThat(runner.threadName()).isEmpty();
        atLast.countDown();
        deaf.join();
        assertThat(log.events).isEmpty();
        assertThat(log.failures).isEmpty();
    }

    @Test
    void isNotWaitedForByATaskThatIsDueWhenTheStateIsLeft() {
        VisitTasks tasks = new VisitTasks(log.visit(), log);
        CountDownLatch never = new CountDownLatch(1);
        tasks.end();
        tasks.run(never::countDown);
        assertThat(never.getCount()).isOne();
        assertThat(log.failures).isEmpty();
        assertThat(tasks.hangsIn()).isEmpty();
    }

    @Test
    void mayEndBeforeItsStateDoes() throws InterruptedException {
        runner.begin(log.visit());
        runner.run(running -> {
            threads.add(Thread.currentThread());
            running.finishAfter(Duration.ofSeconds(5), "timeout");
        });
        take(threads).join();
        assertThat(runner.running()).isNotNull();
        assertThat(runner.threadName()).isEmpty();
        log.clock.advance(Duration.ofSeconds(5));
        assertThat(take(log.events)).isEqualTo("finished timeout");
    }

    @Test
    void reportsWhatItsFunctionThrows() throws InterruptedException {
        runner.begin(log.visit());
        IllegalStateException cause = new IllegalStateException("no camera");
        runner.run(running -> {
            throw cause;
        });
        assertThat(take(log.failures)).isSameAs(cause);
        runner.begin(log.visit());
        runner.run(running -> running.finish("arriveSpot"));
        assertThat(take(log.events)).isEqualTo("finished arriveSpot");
        runner.end();
    }

    @Test
    void canWaitForTheEndOfItsVisit() throws InterruptedException {
        CountDownLatch ended = new CountDownLatch(1);
        HostedVisit visit = log.visit();
        Thread outside = new Thread(() -> {
            try {
                visit.awaitEnd();
                ended.countDown();
            } catch (InterruptedException stop) {
                throw new IllegalStateException(stop);
            }
        });
        outside.start();
        runner.begin(visit);
        runner.begin(log.visit());
        outside.join();
        assertThat(ended.getCount()).isZero();
    }
}
