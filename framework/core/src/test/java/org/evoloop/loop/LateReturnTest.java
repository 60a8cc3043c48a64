package org.evoloop.loop;

import static org.assertj.core.api.Assertions.assertThat;
import static org.evoloop.loop.Relay.await;
import static org.evoloop.loop.Relay.take;

import java.time.Duration;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import org.evoloop.loop.ComponentStatus.Activity;
import org.evoloop.time.ManualClock;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** A component that returns after it was given up does not interfere with what is in the loop by then. */
@InEachThreading
@Timeout(60)
class LateReturnTest {
    private static final Duration LIMIT = Duration.ofSeconds(3);

    private final ManualClock clock = new ManualClock();
    private final List<String> asked = new CopyOnWriteArrayList<>();
    private final Relay relay;

    LateReturnTest(ThreadingModel threading) {
        relay = new Relay(
                LoopConfig.defaults("late", clock)
                        .withThreading(threading)
                        .withStepLimit(LIMIT)
                        .withJoinLimit(Duration.ofMillis(50)),
                (plan, executes, last) -> {
                    asked.add(plan);
                    return Dispatch.<String>toEach().next(plan, executes, last);
                });
        relay.loop.build();
        relay.loop.start();
    }

    @Test
    void nobodyAsksWhichComponentContinuesItsPlan() throws InterruptedException {
        Relay.Hand deaf = relay.new Hand("deaf");
        try (relay) {
            relay.loop.exchange("hand", deaf);
            relay.input.add("deadlock");
            await(deaf.hanging);
            clock.advance(LIMIT);
            take(relay.failures);

            deaf.release.countDown();
            while (relay.status("deaf").activity() == Activity.STUCK) {
                Thread.onSpinWait();
            }
            assertThat(asked).containsExactly("deadlock");
        }
    }

    @Test
    void thePresentComponentGetsNoMoreTime() throws InterruptedException {
        CountDownLatch hanging = new CountDownLatch(1);
        CountDownLatch atLast = new CountDownLatch(1);
        List<Thread> dreaming = new CopyOnWriteArrayList<>();
        Relay.Hand present = relay.new Hand("present");
        try (relay) {
            relay.loop.exchange("hand", present);
            relay.loop.exchange("Brain", new Analyze<String, String>("Dreamer") {
                @Override
                protected @Nullable String analyze(String occurrence) {
                    dreaming.add(Thread.currentThread());
                    hanging.countDown();
                    Relay.awaitUninterruptibly(atLast);
                    return occurrence;
                }
            });
            relay.input.add("dream");
            await(hanging);
            clock.advance(LIMIT);
            take(relay.failures);
            relay.loop.exchange("Dreamer", new Relay.Brain());
            relay.input.add("hang");
            await(present.hanging);

            clock.advance(LIMIT.minusSeconds(1));
            atLast.countDown();
            dreaming.get(0).join();
            clock.advance(Duration.ofSeconds(1));

            assertThat(relay.failures)
                    .extracting(Failure::toString)
                    .containsExactly("present.execute: has not returned for 3000 ms");
        }
    }
}
