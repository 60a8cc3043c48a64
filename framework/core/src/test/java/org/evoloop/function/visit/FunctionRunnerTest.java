package org.evoloop.function.visit;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Consumer;
import org.evoloop.evolution.EventOutcome;
import org.evoloop.evolution.Values;
import org.evoloop.function.Visit;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.time.Clock;
import org.evoloop.time.ManualClock;
import org.evoloop.time.Threads;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

class FunctionRunnerTest {
    private final ManualClock clock = new ManualClock();
    private volatile Runnable noticed = () -> {};

    private final VisitHost host = new VisitHost() {
        @Override
        public State device() {
            return new State("Off");
        }

        @Override
        public Clock clock() {
            return clock;
        }

        @Override
        public boolean threads() {
            return true;
        }

        @Override
        public boolean accepts(Visit visit, Event event) {
            return false;
        }

        @Override
        public void ask(Visit asking, Event event, Values values, Consumer<EventOutcome> then) {
            throw new UnsupportedOperationException("nobody is asked here");
        }

        @Override
        public void send(Visit visit, Event event, Values values) {
            throw new AssertionError(visit + " asks for " + event);
        }

        @Override
        public void requireKnown(Event event) {}

        @Override
        public String unexpected(Visit finishing, Event event) {
            return "";
        }

        @Override
        public void requireNotDeferred(Visit visit, Event event) {}

        @Override
        public void raise(Visit visit, Event event, Values values) {}

        @Override
        public void finish(Visit visit, Event event, Values values) {}

        @Override
        public void notice(String line) {
            noticed.run();
        }

        @Override
        public void failed(Visit visit, Throwable cause) {}
    };

    @Test
    @Timeout(60)
    void anInterruptOfTheThreadThatEndsAFunctionDoesNotCutTheWaitShort() throws Exception {
        FunctionRunner runner = new FunctionRunner(host, Duration.ofSeconds(20));
        Thread caller = Thread.currentThread();
        CountDownLatch started = new CountDownLatch(1);
        AtomicBoolean cleanedUp = new AtomicBoolean();
        AtomicBoolean over = new AtomicBoolean();
        runner.begin(new HostedVisit(new State("Move"), Visit.Beginning.NEW, 1, Values.NONE, host));
        runner.run(visit -> {
            started.countDown();
            try {
                visit.awaitEnd();
            } finally {
                while (caller.getState() != Thread.State.TIMED_WAITING && !over.get()) {
                    Thread.onSpinWait();
                }
                cleanedUp.set(true);
            }
        });
        started.await();

        caller.interrupt();
        runner.end();

        boolean ended = cleanedUp.get();
        over.set(true);
        assertThat(Thread.interrupted()).as("the caller's flag").isTrue();
        assertThat(ended).isTrue();
        assertThat(runner.threadName()).isEmpty();
    }

    @Test
    @Timeout(60)
    void anEndingThatReturnsLateLeavesTheNextVisitAlone() throws InterruptedException {
        FunctionRunner runner = new FunctionRunner(host, Duration.ofSeconds(20));
        CountDownLatch ending = new CountDownLatch(1);
        CountDownLatch atLast = new CountDownLatch(1);
        HostedVisit first = new HostedVisit(new State("Move"), Visit.Beginning.NEW, 1, Values.NONE, host);
        runner.begin(first);
        first.onEnd(() -> {
            ending.countDown();
            awaitUninterruptibly(atLast);
        });
        Thread late = new Thread(runner::end);
        late.start();
        ending.await();

        HostedVisit second = new HostedVisit(new State("Move"), Visit.Beginning.NEW, 2, Values.NONE, host);
        runner.begin(second);
        CountDownLatch started = new CountDownLatch(1);
        AtomicBoolean interrupted = new AtomicBoolean();
        runner.run(visit -> {
            started.countDown();
            try {
                visit.awaitEnd();
            } catch (InterruptedException stop) {
                interrupted.set(visit.isActive());
            }
        });
        started.await();
        atLast.countDown();
        late.join();

        assertThat(runner.running()).isSameAs(second);
        runner.end();
        assertThat(second.isActive()).isFalse();
        assertThat(interrupted).as("interrupted before its state was left").isFalse();
    }

    private static void awaitUninterruptibly(CountDownLatch latch) {
        while (latch.getCount() > 0) {
            try {
                latch.await();
            } catch (InterruptedException deaf) {
                // It is what code does that cannot be stopped.
            }
        }
    }

    @Test
    @Timeout(60)
    void aFunctionDoesNotStartIfItsStateIsLeftAtThatMoment() throws InterruptedException {
        FunctionRunner runner = new FunctionRunner(host, Duration.ofSeconds(20));
        runner.begin(new HostedVisit(new State("Move"), Visit.Beginning.NEW, 1, Values.NONE, host));
        Thread leaving = new Thread(runner::end);
        noticed = () -> {
            leaving.start();
            Threads.join(leaving, Duration.ofSeconds(20));
        };
        CountDownLatch never = new CountDownLatch(1);

        runner.run(visit -> never.await());

        String startedIn = runner.threadName();
        never.countDown();
        assertThat(startedIn).isEmpty();
    }
}
