package org.evoloop.loop;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.evoloop.loop.Relay.take;

import java.time.Duration;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicReference;
import org.evoloop.time.ManualClock;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@InEachThreading
@Timeout(60)
class MapeLoopTest {
    private final ThreadingModel threading;

    MapeLoopTest(ThreadingModel threading) {
        this.threading = threading;
    }

    @Test
    void handsOccurrencesThroughInOrder() throws InterruptedException {
        try (Relay relay = Relay.running(threading)) {
            for (int i = 0; i < 100; i++) {
                relay.input.add("event " + i);
                // The queue holds 8; what is read here has left the loop.
                assertThat(take(relay.output)).isEqualTo("hand:event " + i);
            }
            assertThat(relay.failures).isEmpty();
            assertThat(relay.loop.queueStatus().taken()).isEqualTo(100);
        }
    }

    @Test
    void eachComponentIsKnownByAThread() {
        try (Relay relay = Relay.running(threading)) {
            boolean shared = threading == ThreadingModel.SINGLE_CARRIER;
            assertThat(relay.loop.components())
                    .extracting(ComponentStatus::thread)
                    .containsExactly(
                            "mapek-relay-monitor-ears",
                            shared ? "mapek-relay-carrier" : "mapek-relay-analyze-Brain",
                            shared ? "mapek-relay-carrier" : "mapek-relay-plan-Will",
                            shared ? "mapek-relay-carrier" : "mapek-relay-execute-hand");
        }
    }

    @Test
    void endsTheCycleWhereThereIsNothingToDo() throws InterruptedException {
        try (Relay relay = Relay.running(threading)) {
            relay.input.add("nothing");
            relay.input.add("meaningless");
            relay.input.add("unwanted");
            relay.input.add("last");
            assertThat(take(relay.output)).isEqualTo("hand:last");
            assertThat(relay.failures).isEmpty();
        }
    }

    @Test
    void survivesEverythingThatItsComponentsThrow() throws InterruptedException {
        Relay relay = new Relay(LoopConfig.defaults("relay", new ManualClock()).withThreading(threading));
        try (relay) {
            relay.loop.build();
            relay.loop.start();
            relay.input.add("confusing");
            assertThat(take(relay.failures).toString()).isEqualTo("Brain.analyze: cannot think");
            relay.input.add("clumsy");
            Failure<String> clumsy = take(relay.failures);
            assertThat(clumsy.toString()).isEqualTo("hand.execute: cannot grip");
            assertThat(clumsy.occurrence()).isEqualTo("clumsy");
            assertThat(clumsy.cycle()).isEqualTo(2);
            relay.input.add("fine");
            assertThat(take(relay.output)).isEqualTo("hand:fine");
            assertThat(relay.status("hand").failures()).isEqualTo(1);
            assertThat(relay.status("hand").lastFailure()).contains("cannot grip");
        }
    }

    @Test
    void letsAFailingMonitorRestLongerAndLonger() throws InterruptedException {
        ManualClock clock = new ManualClock();
        Relay relay = new Relay(LoopConfig.defaults("relay", clock).withThreading(threading));
        try (relay) {
            relay.loop.build();
            relay.loop.start();
            for (long millis : new long[] {100, 200, 400, 800, 1600, 3200, 5000, 5000}) {
                relay.input.add("deaf");
                assertThat(take(relay.failures).phase()).isEqualTo("getEvent");
                while (clock.pendingTasks() == 0) {
                    Thread.onSpinWait();
                }
                clock.advance(Duration.ofMillis(millis - 1));
                assertThat(clock.pendingTasks())
                        .as("still resting after %d ms", millis - 1)
                        .isEqualTo(1);
                clock.advance(Duration.ofMillis(1));
            }
            relay.input.add("better");
            assertThat(take(relay.output)).isEqualTo("hand:better");
            relay.input.add("deaf");
            take(relay.failures);
            // Since there was work, the watch over it is pending, too.
            while (clock.pendingTasks() == 1) {
                Thread.onSpinWait();
            }
            clock.advance(Duration.ofMillis(100));
            assertThat(clock.pendingTasks()).as("short again after a success").isEqualTo(1);
        }
    }

    @Test
    void startsAgainAfterStop() throws InterruptedException {
        try (Relay relay = Relay.running(threading)) {
            relay.loop.stop();
            relay.loop.stop();
            assertThat(relay.loop.state()).isEqualTo(LoopState.STOPPED);
            assertThat(relay.loop.offer("while closed")).isFalse();
            assertThat(relay.loop.queueStatus().refused()).isEqualTo(1);

            relay.loop.start();
            relay.loop.start();
            relay.input.add("open again");
            assertThat(take(relay.output)).isEqualTo("hand:open again");
        }
    }

    @Test
    void takesNothingFromTheQueueBeforeItsBeginningIsOver() throws InterruptedException {
        Relay relay = new Relay(LoopConfig.defaults("relay", new ManualClock()).withThreading(threading));
        try (relay) {
            relay.loop.build();
            relay.loop.start(() -> {
                relay.input.add("early");
                while (relay.loop.queueStatus().depth() == 0) {
                    Thread.onSpinWait();
                }
                relay.output.add("beginning");
            });
            relay.loop.start(() -> relay.output.add("beginning again"));
            assertThat(take(relay.output)).isEqualTo("beginning");
            assertThat(take(relay.output)).isEqualTo("hand:early");
        }
    }

    @Test
    void lossesOfAFullQueueAreReportedOnceABurst() throws InterruptedException {
        Relay relay = new Relay(LoopConfig.defaults("relay", new ManualClock())
                .withThreading(threading)
                .withQueueCapacity(2));
        Relay.Hand hand = relay.new Hand("hanging");
        try (relay) {
            relay.loop.build();
            relay.loop.start();
            relay.loop.exchange("hand", hand);
            relay.loop.offer("hang");
            Relay.await(hand.hanging);
            for (String waiting : new String[] {"a", "b", "c", "d"}) {
                relay.loop.offer(waiting);
            }
            assertThat(relay.dropped).containsExactly("c first", "d");
            assertThat(relay.loop.queueStatus()).isEqualTo(new QueueStatus(2, 2, 2, 3, 2, 0));
            hand.release.countDown();
            assertThat(take(relay.output)).isEqualTo("hanging:a");
            assertThat(take(relay.output)).isEqualTo("hanging:b");
        }
    }

    @Test
    void aPutThatMustNotLoseAnythingWaitsForRoom() throws InterruptedException {
        Relay relay = new Relay(LoopConfig.defaults("relay", new ManualClock())
                .withThreading(threading)
                .withQueueCapacity(1));
        Relay.Hand hand = relay.new Hand("hanging");
        try (relay) {
            relay.loop.build();
            relay.loop.start();
            relay.loop.exchange("hand", hand);
            relay.loop.offer("hang");
            Relay.await(hand.hanging);
            relay.loop.offer("a");
            AtomicReference<Boolean> queued = new AtomicReference<>();
            Thread patient = new Thread(() -> {
                try {
                    queued.set(relay.loop.put("b"));
                } catch (InterruptedException e) {
                    queued.set(false);
                }
            });
            patient.start();
            hand.release.countDown();
            patient.join();
            assertThat(queued.get()).isTrue();
            assertThat(take(relay.output)).isEqualTo("hanging:a");
            assertThat(take(relay.output)).isEqualTo("hanging:b");
        }
    }

    @Test
    void withoutAQueueABusyLoopLosesWhatComesAndAnIdleOneTakesIt() throws InterruptedException {
        Relay relay = new Relay(LoopConfig.defaults("relay", new ManualClock())
                .withThreading(threading)
                .withQueueCapacity(0));
        Relay.Hand hand = relay.new Hand("hanging");
        try (relay) {
            relay.loop.build();
            relay.loop.start();
            relay.loop.exchange("hand", hand);
            assertThat(relay.loop.offer("hang")).isTrue();
            Relay.await(hand.hanging);
            assertThat(relay.loop.offer("lost")).isFalse();
            assertThat(relay.dropped).containsExactly("lost first");
            AtomicReference<Boolean> queued = new AtomicReference<>();
            Thread patient = new Thread(() -> {
                try {
                    queued.set(relay.loop.put("waits for the loop to be idle"));
                } catch (InterruptedException e) {
                    queued.set(false);
                }
            });
            patient.start();
            // Only a putter that found the loop busy has to be woken by it.
            while (patient.getState() != Thread.State.WAITING) {
                Thread.onSpinWait();
            }
            hand.release.countDown();
            patient.join();
            assertThat(queued.get()).isTrue();
            assertThat(take(relay.output)).isEqualTo("hanging:waits for the loop to be idle");
        }
    }

    @Test
    void withoutAQueueAndThreadsOneOccurrenceWaitsForItsStep() {
        Relay relay = new Relay(
                LoopConfig.defaults("still", new ManualClock()).withoutThreads().withQueueCapacity(0));
        relay.loop.build();
        relay.loop.start();

        assertThat(relay.loop.offer("one")).isTrue();
        assertThat(relay.loop.offer("lost")).isFalse();
        assertThat(relay.loop.step()).isTrue();
        assertThat(relay.loop.offer("two")).isTrue();
        assertThat(relay.loop.step()).isTrue();

        assertThat(relay.output).containsExactly("hand:one", "hand:two");
    }

    @Test
    void endsEveryThreadAndCanBeClosedTwice() {
        Relay relay = Relay.running(threading);
        relay.close();
        relay.close();

        assertThat(relay.loop.state()).isEqualTo(LoopState.EXITED);
        assertThat(Thread.getAllStackTraces().keySet())
                .extracting(Thread::getName)
                .noneMatch(name -> name.startsWith("mapek-relay-"));
        assertThatThrownBy(relay.loop::start)
                .isInstanceOf(IllegalStateException.class)
                .hasMessageContaining("has ended");
    }

    @Test
    void restoresTheInterruptOfTheClosingThread() {
        Relay relay = Relay.running(threading);
        Thread.currentThread().interrupt();

        relay.close();

        assertThat(Thread.interrupted()).isTrue();
        assertThat(relay.loop.components()).allMatch(status -> status.activity() == ComponentStatus.Activity.ENDED);
    }

    @Test
    void canBeClosedBeforeItIsBuilt() {
        Relay relay = new Relay(LoopConfig.defaults("relay", new ManualClock()).withThreading(threading));
        relay.close();
        assertThat(relay.loop.state()).isEqualTo(LoopState.EXITED);
    }

    @Test
    void namesEverythingThatIsMissing() {
        MapeLoop<String, String, String> empty = new MapeLoop<>(
                LoopConfig.defaults("empty", new ManualClock()),
                new Relay(LoopConfig.defaults("r", new ManualClock())).listener());
        assertThatThrownBy(empty::build)
                .hasMessageContaining("no analyze")
                .hasMessageContaining("no plan")
                .hasMessageContaining("no execute");
        assertThatThrownBy(() -> new Relay(LoopConfig.defaults("bad", new ManualClock())
                        .withQueueCapacity(-1)
                        .withStepLimit(Duration.ZERO)
                        .withJoinLimit(Duration.ofHours(1))))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("queueCapacity is -1, allowed is 0 to 1000000")
                .hasMessageContaining("stepLimit is PT0S")
                .hasMessageContaining("joinLimit is PT1H");
    }

    @Test
    void takesStepsWithoutThreads() throws InterruptedException {
        Relay relay = new Relay(LoopConfig.defaults("still", new ManualClock()).withoutThreads());
        Relay.Ears ears = relay.new Ears("more ears");
        relay.loop.addMonitor(ears);
        relay.loop.build();
        relay.loop.start();
        assertThat(relay.loop.step()).isFalse();

        relay.input.add("one");
        relay.loop.observe(ears);
        relay.loop.offer("clumsy");
        relay.loop.offer("two");

        assertThat(relay.output).isEmpty();
        assertThat(relay.loop.step()).isTrue();
        assertThat(relay.output).containsExactly("hand:one");
        assertThat(relay.loop.step()).isTrue();
        assertThat(relay.failures).hasSize(1);
        assertThat(relay.loop.step()).isTrue();
        assertThat(relay.output).containsExactly("hand:one", "hand:two");
        assertThat(relay.loop.step()).isFalse();
        relay.close();
    }

    @Test
    void handsAPlanToEveryExecuteComponent() throws InterruptedException {
        try (Relay relay = Relay.running(threading)) {
            relay.loop.addExecute(relay.new Hand("left"));
            relay.input.add("clap");
            assertThat(take(relay.output)).isEqualTo("hand:clap");
            assertThat(take(relay.output)).isEqualTo("left:clap");
            relay.loop.remove("hand");
            relay.input.add("wave");
            assertThat(take(relay.output)).isEqualTo("left:wave");
            assertThatThrownBy(() -> relay.loop.remove("left")).hasMessageContaining("exchange it instead");
        }
    }

    @Test
    void cannotBeChangedFromItsOwnThread() throws InterruptedException {
        try (Relay relay = Relay.running(threading)) {
            AtomicReference<Throwable> refusal = new AtomicReference<>();
            CountDownLatch tried = new CountDownLatch(1);
            relay.loop.addExecute(new Execute<>("saboteur") {
                @Override
                protected void execute(String plan) {
                    try {
                        relay.loop.stop();
                    } catch (IllegalStateException e) {
                        refusal.set(e);
                    }
                    tried.countDown();
                }
            });
            relay.input.add("go");
            Relay.await(tried);
            assertThat(refusal.get())
                    .hasMessageContaining(
                            "from its own thread " + relay.status("saboteur").thread());
        }
    }
}
