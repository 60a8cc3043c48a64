package org.evoloop.time;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.TimeUnit;
import org.awaitility.Awaitility;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(60)
class RequestThreadsTest {
    private static final Duration LIMIT = Duration.ofSeconds(10);
    private static final Duration PATIENCE = Duration.ofSeconds(30);

    private final ManualClock clock = new ManualClock();
    private final RequestThreads threads = new RequestThreads("waiter", 2, LIMIT, clock);
    private final BlockingQueue<String> ended = new LinkedBlockingQueue<>();

    @AfterEach
    void close() {
        threads.close();
    }

    /** Begins a request that sets its limit and waits for a latch, and says how that ended. */
    private void begin(String request, Runnable setsLimit, CountDownLatch latch) throws InterruptedException {
        CountDownLatch begun = new CountDownLatch(1);
        threads.execute(() -> {
            setsLimit.run();
            begun.countDown();
            try {
                latch.await();
                ended.add(request + " was answered");
            } catch (InterruptedException interrupted) {
                ended.add(request + " was interrupted");
            }
        });
        begun.await();
    }

    private String next() throws InterruptedException {
        return String.valueOf(ended.poll(PATIENCE.toSeconds(), TimeUnit.SECONDS));
    }

    @Test
    void noMoreThanTheMostAreServedAtATime() throws Exception {
        CountDownLatch answer = new CountDownLatch(1);
        begin("this", () -> threads.limit(LIMIT), answer);
        begin("this", threads::unlimited, answer);
        assertThatThrownBy(() -> threads.execute(() -> ended.add("one too many")))
                .isInstanceOf(RejectedExecutionException.class);
        answer.countDown();
        assertThat(next()).isEqualTo("this was answered");
        assertThat(next()).isEqualTo("this was answered");
        // The threads that gave the answers may take longer than usual until they are free.
        Awaitility.await()
                .atMost(PATIENCE)
                .ignoreExceptionsInstanceOf(RejectedExecutionException.class)
                .until(() -> {
                    threads.execute(() -> ended.add("the next one"));
                    return true;
                });
        assertThat(next()).isEqualTo("the next one");
    }

    /** Whoever only begins requests holds up nobody; who has been heard to the end is answered. */
    @Test
    void theOldestIncompleteRequestMakesRoom() throws Exception {
        CountDownLatch answer = new CountDownLatch(1);
        begin("the complete one", () -> threads.limit(LIMIT), answer);
        for (int half = 1; half <= 40; half++) {
            begin("half " + half, () -> {}, new CountDownLatch(1));
        }
        begin("the next one", threads::unlimited, answer);
        for (int half = 1; half <= 40; half++) {
            assertThat(next()).isEqualTo("half " + half + " was interrupted");
        }
        answer.countDown();
        assertThat(List.of(next(), next()))
                .containsExactlyInAnyOrder("the complete one was answered", "the next one was answered");
    }

    /** A request that is completed in the moment when it is given up is answered. */
    @Test
    void aRequestThatIsGivenUpWhenItIsCompleteIsAnswered() throws Exception {
        begin("the first", threads::unlimited, new CountDownLatch(1));
        threads.execute(() -> {
            ended.add("read");
            while (!Thread.currentThread().isInterrupted()) {
                Thread.onSpinWait();
            }
            threads.limit(LIMIT);
            ended.add("interrupted: " + Thread.currentThread().isInterrupted());
        });
        assertThat(next()).isEqualTo("read");
        try {
            threads.execute(() -> {});
        } catch (RejectedExecutionException full) {
            // The thread may take longer than usual until it is free.
        }
        assertThat(next()).isEqualTo("interrupted: false");
    }

    /** A client may ask again as soon as it has its answer, when the thread that gave it has not quite finished. */
    @Test
    void oneRequestAfterAnotherIsAlwaysServed() throws Exception {
        try (RequestThreads one = new RequestThreads("server", 1, LIMIT, clock, PATIENCE)) {
            for (int i = 0; i < 5_000; i++) {
                CountDownLatch answered = new CountDownLatch(1);
                one.execute(answered::countDown);
                answered.await();
            }
        }
    }

    @Test
    void aRequestThatIsLateIsInterruptedAndOneWithMoreTimeIsNot() throws Exception {
        CountDownLatch answer = new CountDownLatch(1);
        begin("the longer one", () -> threads.limit(LIMIT.multipliedBy(2)), answer);
        begin("the other one", () -> {}, answer);
        clock.advance(LIMIT);
        assertThat(next()).isEqualTo("the other one was interrupted");
        clock.advance(LIMIT);
        assertThat(next()).isEqualTo("the longer one was interrupted");
    }

    @Test
    void aRequestWithoutALimitWaits() throws Exception {
        CountDownLatch answer = new CountDownLatch(1);
        begin("the patient one", threads::unlimited, answer);
        begin("the other one", () -> {}, new CountDownLatch(1));
        clock.advance(LIMIT.multipliedBy(100));
        assertThat(next()).isEqualTo("the other one was interrupted");
        answer.countDown();
        assertThat(next()).isEqualTo("the patient one was answered");
    }

    @Test
    void anInterruptThatComesTooLateIsForgotten() throws Exception {
        threads.execute(() -> {
            ended.add("started");
            while (!Thread.currentThread().isInterrupted()) {
                Thread.onSpinWait();
            }
            threads.unlimited();
            ended.add("interrupted: " + Thread.currentThread().isInterrupted());
        });
        assertThat(next()).isEqualTo("started");
        clock.advance(LIMIT);
        assertThat(next()).isEqualTo("interrupted: false");
    }

    @Test
    void closingInterruptsAllAndRefusesMore() throws Exception {
        begin("the patient one", threads::unlimited, new CountDownLatch(1));
        threads.close();
        threads.close();
        assertThat(next()).isEqualTo("the patient one was interrupted");
        assertThatThrownBy(() -> threads.execute(() -> {})).isInstanceOf(RejectedExecutionException.class);
    }

    @Test
    void withoutRequestsThereIsNoThread() throws Exception {
        threads.execute(() -> ended.add("done"));
        assertThat(next()).isEqualTo("done");
        Awaitility.await()
                .atMost(PATIENCE)
                .until(() -> Thread.getAllStackTraces().keySet().stream()
                        .noneMatch(thread -> thread.getName().startsWith("waiter")));
    }
}
