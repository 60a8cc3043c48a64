package org.evoloop.converter;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.evoloop.RecordingExecute;
import org.evoloop.evolution.EventOutcome;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Step;
import org.evoloop.evolution.Values;
import org.evoloop.loop.LoopConfig;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.time.ManualClock;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Who submits an event learns what became of it, with and without threads. */
@Timeout(20)
class SubmitTest {
    private static final StateMachine LIFT = StateMachine.named("lift")
            .initial("F")
            .transition("F", "up", "G")
            .transition("G", "up", "H")
            .transition("H", "down", "G")
            .build();

    private static final StateMachine EXPRESS = StateMachine.named("express")
            .initial("F")
            .transition("F", "up", "G")
            .transition("G", "up", "H")
            .transition("H", "down", "G")
            .transition("F", "express [light load]", "H")
            .transition("G", "ring", "Ringing")
            .transition("Ringing", "stop", "G")
            .build();

    private final ManualClock clock = new ManualClock();
    private final PushMonitor panel = new PushMonitor("Panel");
    private final RecordingExecute lift = new RecordingExecute("Lift", "up", "down");

    private SystemEventConverter start(LoopConfig config, EventExecute execute) {
        SystemEventConverter converter = new SystemEventConverter(config);
        converter.addMonitor(panel);
        converter.addExecute(execute);
        converter.addAnalyze(new EventAnalyze() {
            @Override
            protected Analysis analyze(Occurrence occurrence) {
                return occurrence.label().equals("down")
                        ? refuse(occurrence, "nobody goes down here")
                        : super.analyze(occurrence);
            }
        });
        converter.addKnowledge(new StateKnowledge(new ModelPair(LIFT, EXPRESS)) {
            @Override
            protected void registerNewFunctions() {
                guard("light load", values -> values.number("load") < 300);
                function("Ringing", visit -> {});
            }
        });
        converter.build();
        converter.start();
        return converter;
    }

    private SystemEventConverter stepped() {
        return start(LoopConfig.defaults("lift", clock).withoutThreads().withQueueCapacity(1), lift);
    }

    private static void settle(SystemEventConverter converter, PushMonitor panel) throws InterruptedException {
        converter.observe(panel);
        while (converter.step()) {
            converter.observe(panel);
        }
    }

    @Test
    void handledWithWhatWasSent() throws InterruptedException {
        try (SystemEventConverter converter = stepped()) {
            CompletableFuture<EventOutcome> outcome = panel.submit("express", Values.of("load", 100));
            assertThat(outcome).isNotDone();
            settle(converter, panel);
            assertThat(outcome.join()).isInstanceOfSatisfying(EventOutcome.Handled.class, handled -> {
                assertThat(handled.from()).hasToString("(F, F)");
                assertThat(handled.to()).hasToString("(H, H)");
                assertThat(handled.sent()).isEqualTo(List.of(new Event("up"), new Event("up")));
                assertThat(handled).hasToString("handled: H, sent up, up");
            });
        }
    }

    @Test
    void notAcceptableWithTheGuardThatIsFalse() throws InterruptedException {
        try (SystemEventConverter converter = stepped()) {
            CompletableFuture<EventOutcome> heavy = panel.submit("express", Values.of("load", 400));
            settle(converter, panel);
            CompletableFuture<EventOutcome> nowhere = panel.submit("ring");
            settle(converter, panel);
            assertThat(heavy.join())
                    .isInstanceOf(EventOutcome.NotAcceptable.class)
                    .hasToString("not acceptable in F: [light load] is false for load=400");
            assertThat(nowhere.join()).hasToString("not acceptable in F");
            assertThat(converter.history().get(0).detail())
                    .isEqualTo(heavy.join().toString());
        }
    }

    @Test
    void refusedByARuleOfTheConverter() throws InterruptedException {
        try (SystemEventConverter converter = stepped()) {
            panel.submit("up");
            settle(converter, panel);
            panel.submit("up");
            settle(converter, panel);
            CompletableFuture<EventOutcome> down = panel.submit("down");
            settle(converter, panel);
            assertThat(down.join()).isEqualTo(new EventOutcome.Refused("nobody goes down here"));
        }
    }

    @Test
    void droppedByAFullQueueAndRefusedWhileStopped() throws InterruptedException {
        try (SystemEventConverter converter = stepped()) {
            CompletableFuture<EventOutcome> first = panel.submit("up");
            CompletableFuture<EventOutcome> second = panel.submit("up");
            converter.observe(panel);
            converter.observe(panel);
            settle(converter, panel);
            assertThat(first.join().isHandled()).isTrue();
            assertThat(second.join()).isInstanceOf(EventOutcome.Dropped.class);

            converter.stop();
            assertThat(panel.submit("up").join())
                    .isEqualTo(new EventOutcome.Refused("the converter lift is stopped; start it first"));
        }
    }

    @Test
    void whatWaitsWhenTheConverterIsClosedIsRefused() {
        CompletableFuture<EventOutcome> waiting;
        try (SystemEventConverter converter = stepped()) {
            waiting = panel.submit("up");
            assertThat(converter.status().events().handled()).isZero();
        }
        assertThat(waiting.join()).isInstanceOf(EventOutcome.Refused.class);
    }

    @Test
    void whatAPressAcceptedIsNotDroppedLaterWithoutThreads() throws InterruptedException {
        try (SystemEventConverter converter = stepped()) {
            int accepted = 0;
            for (int press = 0; press < 5_000; press++) {
                try {
                    panel.press("up");
                    accepted++;
                } catch (IllegalStateException full) {
                    assertThat(full).hasMessageContaining("has a full queue");
                }
            }
            settle(converter, panel);
            assertThat(accepted).isEqualTo(1);
            assertThat(converter.status().events().handled()).isEqualTo(accepted);
            assertThat(converter.status().queue().dropped()).isEqualTo(4_999);
        }
    }

    @Test
    void whatWaitsBehindAMonitorThatIsRemovedIsRefused() throws Exception {
        LoopConfig config = LoopConfig.defaults("lift", clock);
        try (SystemEventConverter converter = start(config, lift)) {
            converter.remove("Panel");
            assertThatThrownBy(() -> panel.submit("up")).hasMessageContaining("is not part of a converter");
            assertThat(converter.status().events().handled()).isZero();
        }
    }

    @Test
    void staleAfterTooLong() throws InterruptedException {
        LoopConfig impatient =
                LoopConfig.defaults("lift", clock).withoutThreads().withPressAge(Duration.ofSeconds(5));
        try (SystemEventConverter converter = start(impatient, lift)) {
            panel.submit("up");
            CompletableFuture<EventOutcome> old = panel.submit("up");
            converter.observe(panel);
            converter.observe(panel);
            clock.advance(Duration.ofSeconds(9));
            settle(converter, panel);
            assertThat(old.join()).isEqualTo(new EventOutcome.Stale("pressed 9 s before its turn; the limit is 5 s"));
        }
    }

    @Test
    void failedWithThreadsAndTheReason() throws Exception {
        EventExecute jammed = new EventExecute("Lift") {
            @Override
            protected Set<String> sendableEvents() {
                return Set.of("up", "down");
            }

            @Override
            protected void send(Step step) {
                throw new IllegalStateException("the door is open");
            }
        };
        try (SystemEventConverter converter = start(LoopConfig.defaults("lift", clock), jammed)) {
            assertThat(panel.submit("up").get(10, TimeUnit.SECONDS))
                    .isInstanceOfSatisfying(EventOutcome.Failed.class, failed -> {
                        assertThat(failed.to()).hasToString("(F, F)");
                        assertThat(failed.why()).contains("the door is open");
                    });
            assertThat(converter.status().events().failed()).isEqualTo(1);
        }
    }

    @Test
    void anUnknownEventIsRefusedAtOnce() {
        try (SystemEventConverter converter = stepped()) {
            assertThat(converter).isNotNull();
            assertThatThrownBy(() -> panel.submit("upp")).hasMessageContaining("did you mean up?");
        }
    }

    @Test
    void aFunctionAsksForOneEventAtATime() throws InterruptedException {
        List<CompletableFuture<EventOutcome>> asked = new ArrayList<>();
        try (SystemEventConverter converter =
                new SystemEventConverter(LoopConfig.defaults("lift", clock).withoutThreads())) {
            converter.addMonitor(panel);
            converter.addExecute(lift);
            converter.addKnowledge(new StateKnowledge(new ModelPair(LIFT, EXPRESS)) {
                @Override
                protected void registerNewFunctions() {
                    guard("light load", values -> false);
                    sends("Ringing", "up");
                    function("Ringing", visit -> {
                        asked.add(visit.ask("up"));
                        asked.add(visit.ask("up"));
                        asked.get(0).thenAccept(done -> asked.add(visit.ask("up")));
                    });
                }
            });
            converter.build();
            converter.start();
            panel.press("up");
            settle(converter, panel);
            panel.press("ring");
            settle(converter, panel);
        }
        assertThat(lift.sent()).containsExactly("up", "up");
        assertThat(asked.get(0).join()).hasToString("handled: Ringing, sent up");
        assertThat(asked.get(1).join()).isInstanceOf(EventOutcome.Refused.class);
        assertThat(asked.get(2).join()).as("not possible in H").isInstanceOf(EventOutcome.Failed.class);
    }
}
