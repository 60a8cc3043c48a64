package org.evoloop.loop;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.evoloop.loop.Relay.take;

import java.time.Duration;
import java.util.concurrent.CountDownLatch;
import org.evoloop.loop.ComponentStatus.Activity;
import org.evoloop.time.ManualClock;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Components that are exchanged, hang, or do not end. */
@InEachThreading
@Timeout(60)
class ExchangeTest {
    private static final Duration SHORT = Duration.ofMillis(50);
    private final ThreadingModel threading;

    ExchangeTest(ThreadingModel threading) {
        this.threading = threading;
    }

    @Test
    void exchangesEachRoleWhileRunning() throws InterruptedException {
        try (Relay relay = Relay.running(threading)) {
            relay.loop.exchange("ears", relay.new Ears("new ears"));
            relay.loop.exchange("Brain", new Analyze<String, String>("poet") {
                @Override
                protected String analyze(String occurrence) {
                    return occurrence + " like a rose";
                }
            });
            relay.loop.exchange("Will", new Plan<String, String>("optimist") {
                @Override
                protected String plan(String analysis) {
                    return analysis + "!";
                }
            });
            relay.loop.exchange("hand", relay.new Hand("foot"));

            relay.input.add("red");

            assertThat(take(relay.output)).isEqualTo("foot:red like a rose!");
            assertThat(relay.loop.components())
                    .extracting(ComponentStatus::name)
                    .containsExactly("new ears", "poet", "optimist", "foot");
        }
    }

    @Test
    void letsTheOccurrenceInTheLoopComeToItsEndFirst() throws InterruptedException {
        try (Relay relay = Relay.running(threading)) {
            CountDownLatch working = new CountDownLatch(1);
            CountDownLatch proceed = new CountDownLatch(1);
            relay.loop.addExecute(new Execute<>("slow") {
                @Override
                protected void execute(String plan) throws InterruptedException {
                    working.countDown();
                    proceed.await();
                    relay.output.add("slow:" + plan);
                }
            });
            relay.input.add("first");
            Relay.await(working);
            relay.input.add("second");
            Thread admin = new Thread(() -> relay.loop.exchange("slow", relay.new Hand("quick")));
            admin.start();
            while (admin.getState() != Thread.State.TIMED_WAITING) {
                Thread.onSpinWait();
            }
            proceed.countDown();
            admin.join();

            assertThat(take(relay.output)).isEqualTo("hand:first");
            assertThat(take(relay.output)).isEqualTo("slow:first");
            assertThat(take(relay.output)).isEqualTo("hand:second");
            assertThat(take(relay.output)).isEqualTo("quick:second");
            assertThat(relay.failures).isEmpty();
        }
    }

    @Test
    void interruptsAComponentThatHangsWhenItIsExchanged() throws InterruptedException {
        // The interrupted thread has as long to return; on a busy machine it gets no processor time for a while.
        Relay relay = Relay.running(threading, Duration.ofSeconds(1));
        Relay.Hand hanging = relay.new Hand("hanging");
        try (relay) {
            relay.loop.exchange("hand", hanging);
            relay.input.add("hang");
            Relay.await(hanging.hanging);
            relay.loop.exchange("hanging", relay.new Hand("healthy"));

            assertThat(take(relay.failures).toString()).contains("hanging.execute: was interrupted");
            relay.input.add("next");
            assertThat(take(relay.output)).isEqualTo("healthy:next");
        }
    }

    @Test
    void leavesBehindAComponentThatIgnoresInterrupts() throws InterruptedException {
        Relay relay = Relay.running(threading, SHORT);
        Relay.Hand deaf = relay.new Hand("deaf");
        try (relay) {
            relay.loop.exchange("hand", deaf);
            relay.input.add("deadlock");
            Relay.await(deaf.hanging);
            relay.loop.exchange("deaf", relay.new Hand("healthy"));
            relay.input.add("next");
            assertThat(take(relay.output)).isEqualTo("healthy:next");

            // When it finally returns, its result is ignored.
            deaf.release.countDown();
            assertThat(take(relay.output)).isEqualTo("deaf:too late");
            relay.input.add("and on");
            assertThat(take(relay.output)).isEqualTo("healthy:and on");
            assertThat(relay.failures).hasSize(1);
        }
    }

    @Test
    void givesUpAStepThatTakesTooLong() throws InterruptedException {
        ManualClock clock = new ManualClock();
        Relay relay = new Relay(
                LoopConfig.defaults("relay", clock).withThreading(threading).withStepLimit(Duration.ofSeconds(3)));
        Relay.Hand deaf = relay.new Hand("deaf");
        try (relay) {
            relay.loop.build();
            relay.loop.start();
            relay.loop.exchange("hand", deaf);
            relay.input.add("deadlock");
            Relay.await(deaf.hanging);
            clock.advance(Duration.ofMillis(2999));
            assertThat(relay.failures).isEmpty();
            clock.advance(Duration.ofMillis(1));
            assertThat(take(relay.failures).toString()).isEqualTo("deaf.execute: has not returned for 3000 ms");
            assertThat(relay.status("deaf").activity()).isEqualTo(Activity.STUCK);

            // What arrives while it is stuck fails at once, and the message says how to recover.
            relay.input.add("next");
            assertThat(take(relay.failures).toString())
                    .contains("is stuck in its thread")
                    .contains("exchange it");

            deaf.release.countDown();
            assertThat(take(relay.output)).isEqualTo("deaf:too late");
            while (relay.status("deaf").activity() == Activity.STUCK) {
                Thread.onSpinWait();
            }
            relay.input.add("after all");
            assertThat(take(relay.output)).isEqualTo("deaf:after all");
        }
    }

    @Test
    void replacesAMonitorThatWaitsAndLosesNothingItHasReported() throws InterruptedException {
        try (Relay relay = Relay.running(threading)) {
            CountDownLatch asked = new CountDownLatch(1);
            relay.loop.addMonitor(new Monitor<>("dreamer") {
                @Override
                protected @Nullable String getEvent() throws InterruptedException {
                    asked.countDown();
                    try {
                        new CountDownLatch(1).await();
                        return null;
                    } catch (InterruptedException woken) {
                        return "dream";
                    }
                }
            });
            Relay.await(asked);
            relay.loop.remove("dreamer");
            assertThat(take(relay.output)).isEqualTo("hand:dream");
            assertThat(Thread.getAllStackTraces().keySet())
                    .extracting(Thread::getName)
                    .doesNotContain("mapek-relay-monitor-dreamer");
        }
    }

    @Test
    void closesInTimeAlthoughAComponentIgnoresInterrupts() throws InterruptedException {
        Relay relay = Relay.running(threading, SHORT);
        Relay.Hand deaf = relay.new Hand("deaf");
        relay.loop.exchange("hand", deaf);
        relay.input.add("deadlock");
        Relay.await(deaf.hanging);

        relay.close();

        assertThat(relay.loop.state()).isEqualTo(LoopState.EXITED);
        deaf.release.countDown();
    }

    @Test
    void refusesWhatDoesNotFit() {
        try (Relay relay = Relay.running(threading)) {
            assertThatThrownBy(() -> relay.loop.exchange("nose", relay.new Hand("foot")))
                    .isInstanceOf(IllegalArgumentException.class)
                    .hasMessage("no component is named nose; there are ears, Brain, Will, hand");
            assertThatThrownBy(() -> relay.loop.exchange("ears", relay.new Hand("foot")))
                    .isInstanceOf(IllegalArgumentException.class)
                    .hasMessageContaining("of the role MONITOR");
            assertThatThrownBy(() -> relay.loop.addMonitor(relay.new Ears("hand")))
                    .isInstanceOf(IllegalStateException.class)
                    .hasMessageContaining("named hand already");
            assertThatThrownBy(() -> relay.loop.addPlan(new Relay.Will())).isInstanceOf(IllegalStateException.class);
            assertThatThrownBy(() -> relay.loop.remove("Will")).hasMessageContaining("exchange it instead");
        }
    }
}
