package org.evoloop.converter;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CountDownLatch;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Step;
import org.evoloop.loop.LoopConfig;
import org.evoloop.loop.ThreadingModel;
import org.evoloop.statemachine.ModelException;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.time.ManualClock;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** An alarm while an elevator is on its way and presses have filled the queue, in a converter with its threads. */
@Timeout(20)
class UrgentEventTest {
    private static final StateMachine LIFT = StateMachine.named("lift")
            .initial("F")
            .transition("F", "up", "G")
            .transition("G", "up", "H")
            .transition("H", "up", "I")
            .build();

    private final PushMonitor panel = new PushMonitor("Panel");
    private final CountDownLatch alarmed = new CountDownLatch(1);
    private final Lift lift = new Lift();

    private static StateMachine express() {
        return StateMachine.named("express")
                .initial("F")
                .transition("F", "up", "G")
                .transition("G", "up", "H")
                .transition("H", "up", "I")
                .transition("F", "express", "I")
                .transition("F", "fire", "Alarm")
                .transition("G", "fire", "Alarm")
                .transition("H", "fire", "Alarm")
                .transition("I", "fire", "Alarm")
                .build();
    }

    /** While the first step is on its way, somebody presses many times, and then there is an alarm. */
    private final class Lift extends EventExecute {
        private final List<String> sent = new ArrayList<>();
        private int lost;

        @Override
        protected Set<String> sendableEvents() {
            return Set.of("up");
        }

        @Override
        protected void send(Step step) {
            sent.add(step.trigger().name());
            for (int presses = 0; presses < 20 && sent.size() == 1; presses++) {
                try {
                    panel.press("up");
                } catch (IllegalStateException full) {
                    lost++;
                }
            }
            panel.press("fire");
        }
    }

    private StateKnowledge knowledge(String urgent) {
        return new StateKnowledge(new ModelPair(LIFT, express())) {
            @Override
            protected void registerNewFunctions() {
                urgent(urgent);
                function("Alarm", visit -> alarmed.countDown());
            }
        };
    }

    @ParameterizedTest
    @EnumSource(mode = EnumSource.Mode.EXCLUDE, names = "CALLER")
    void isHeardAfterOneStepWhateverWaits(ThreadingModel threading) throws InterruptedException {
        try (SystemEventConverter converter = new SystemEventConverter(
                LoopConfig.defaults("lift", new ManualClock()).withThreading(threading))) {
            converter.addMonitor(panel);
            converter.addExecute(lift);
            converter.addKnowledge(knowledge("fire"));
            converter.build();
            converter.start();

            panel.press("express");
            alarmed.await();

            assertThat(lift.sent).containsExactly("up");
            assertThat(lift.lost).isPositive();
            assertThat(converter.knowledge().configuration()).hasToString("(G, Alarm)");
            assertThat(converter.history())
                    .extracting(entry -> entry.occurrence().label() + " " + entry.outcome() + " " + entry.detail())
                    .contains("express OVERTAKEN fire came, which is urgent")
                    .filteredOn(entry -> entry.startsWith("fire"))
                    .containsExactly("fire HANDLED new function of Alarm");
        }
    }

    @Test
    void aMisspeltOneIsRefused() {
        try (SystemEventConverter converter = new SystemEventConverter(
                LoopConfig.defaults("lift", new ManualClock()).withoutThreads())) {
            converter.addMonitor(panel);
            converter.addExecute(lift);
            converter.addKnowledge(knowledge("fier"));
            assertThatThrownBy(converter::build)
                    .isInstanceOf(ModelException.class)
                    .hasMessageContaining("an event is registered as urgent, fier, which is not an event of the new "
                            + "model; did you mean fire?");
        }
    }
}
