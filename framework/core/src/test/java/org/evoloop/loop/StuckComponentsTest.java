package org.evoloop.loop;

import static org.assertj.core.api.Assertions.assertThat;
import static org.evoloop.loop.Relay.await;
import static org.evoloop.loop.Relay.take;

import java.time.Duration;
import java.util.concurrent.CountDownLatch;
import org.evoloop.loop.ComponentStatus.Activity;
import org.evoloop.time.ManualClock;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** A component that does not return affects only the work that needs it. */
@InEachThreading
@Timeout(60)
class StuckComponentsTest {
    private static final Duration LIMIT = Duration.ofSeconds(3);

    private final ManualClock clock = new ManualClock();
    private final Relay relay;

    StuckComponentsTest(ThreadingModel threading) {
        relay = new Relay(LoopConfig.defaults("stuck", clock)
                .withThreading(threading)
                .withStepLimit(LIMIT)
                .withJoinLimit(Duration.ofMillis(50)));
        relay.loop.build();
        relay.loop.start();
    }

    /** Analyzes "deadlock" until it is released. */
    private static final class Dreamer extends Analyze<String, String> {
        final CountDownLatch hanging = new CountDownLatch(1);
        final CountDownLatch release = new CountDownLatch(1);

        @Override
        protected @Nullable String analyze(String occurrence) {
            if (occurrence.equals("deadlock")) {
                hanging.countDown();
                Relay.awaitUninterruptibly(release);
            }
            return occurrence;
        }
    }

    private void hangs(Relay.Hand hand) throws InterruptedException {
        hangs("hand", hand, hand.hanging);
    }

    private void hangs(Dreamer dreamer) throws InterruptedException {
        hangs("Brain", dreamer, dreamer.hanging);
    }

    private void hangs(String name, Component next, CountDownLatch hanging) throws InterruptedException {
        relay.loop.exchange(name, next);
        relay.input.add("deadlock");
        await(hanging);
    }

    @Test
    void othersDoNotNotice() throws InterruptedException {
        Relay.Hand deaf = relay.new Hand("deaf");
        try (relay) {
            hangs(deaf);
            String where = relay.status("deaf").thread();
            clock.advance(LIMIT);
            take(relay.failures);

            assertThat(relay.status("deaf").thread()).isEqualTo(where);
            for (String role : new String[] {"Brain", "Will"}) {
                assertThat(relay.status(role).thread()).isNotEqualTo(where);
                // It passes on before it is done.
                while (relay.status(role).activity() != Activity.WAITING) {
                    Thread.onSpinWait();
                }
            }
            relay.input.add("confusing");
            assertThat(take(relay.failures).toString()).isEqualTo("Brain.analyze: cannot think");
            relay.loop.exchange("deaf", relay.new Hand("healthy"));
            relay.input.add("next");
            assertThat(take(relay.output)).isEqualTo("healthy:next");
            deaf.release.countDown();
        }
    }

    @Test
    void severalMayHangAtOnceAndEachComesBackByItself() throws InterruptedException {
        Relay.Hand left = relay.new Hand("left");
        Dreamer dreamer = new Dreamer();
        try (relay) {
            hangs(left);
            clock.advance(LIMIT);
            take(relay.failures);
            hangs(dreamer);
            clock.advance(LIMIT);
            assertThat(take(relay.failures).component()).isEqualTo("Dreamer");

            left.release.countDown();
            assertThat(take(relay.output)).isEqualTo("left:too late");
            awaitReturn("left");
            relay.input.add("first");
            assertThat(take(relay.failures).toString()).startsWith("Dreamer.analyze: is stuck in its thread");
            dreamer.release.countDown();
            awaitReturn("Dreamer");
            relay.input.add("second");
            assertThat(take(relay.output)).isEqualTo("left:second");
        }
    }

    private void awaitReturn(String name) {
        while (relay.status(name).activity() == Activity.STUCK) {
            Thread.onSpinWait();
        }
    }

    @Test
    void whateverWaitsForAnAnalyzeThatHangsFailsAtOnce() throws InterruptedException {
        Dreamer dreamer = new Dreamer();
        try (relay) {
            hangs(dreamer);
            for (int i = 0; i < 5; i++) {
                relay.loop.offer("waiting " + i);
            }
            clock.advance(LIMIT);
            assertThat(take(relay.failures).toString()).isEqualTo("Dreamer.analyze: has not returned for 3000 ms");
            for (int i = 0; i < 5; i++) {
                Failure<String> failure = take(relay.failures);
                assertThat(failure.occurrence()).isEqualTo("waiting " + i);
                assertThat(failure.toString())
                        .contains("is stuck in its thread")
                        .contains("exchange it");
            }
            relay.loop.offer("one more");
            assertThat(take(relay.failures).occurrence()).isEqualTo("one more");

            relay.loop.exchange("Dreamer", new Relay.Brain());
            relay.input.add("next");
            assertThat(take(relay.output)).isEqualTo("hand:next");
            dreamer.release.countDown();
        }
    }

    @Test
    void aListenerThatThrowsStopsNothing() throws InterruptedException {
        Relay.Hand hand = relay.new Hand("slow");
        try (relay) {
            relay.loop.exchange("hand", hand);
            relay.listenerFails = true;
            relay.input.add("confusing");
            take(relay.failures);
            relay.input.add("hang");
            await(hand.hanging);
            clock.advance(LIMIT);
            take(relay.failures);
            relay.input.add("next");
            assertThat(take(relay.output)).isEqualTo("slow:next");
        }
    }

    @Test
    void theThreadInWhichOneHungEndsOrServesItAgain() throws InterruptedException {
        Relay.Hand deaf = relay.new Hand("deaf");
        try (relay) {
            hangs(deaf);
            clock.advance(LIMIT);
            take(relay.failures);
            deaf.release.countDown();
            awaitReturn("deaf");
            relay.input.add("after all");
            assertThat(take(relay.output)).isEqualTo("deaf:too late");
            assertThat(take(relay.output)).isEqualTo("deaf:after all");
        }
        for (Thread thread : Thread.getAllStackTraces().keySet()) {
            if (thread.getName().startsWith("mapek-stuck-")) {
                thread.join();
            }
        }
    }
}
