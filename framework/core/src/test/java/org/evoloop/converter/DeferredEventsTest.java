package org.evoloop.converter;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.time.Duration;
import java.time.LocalTime;
import java.util.ArrayList;
import java.util.List;
import org.evoloop.RecordingExecute;
import org.evoloop.evolution.ModelPair;
import org.evoloop.function.NewFunction;
import org.evoloop.loop.LoopConfig;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.ModelException;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.Transition;
import org.evoloop.time.ManualClock;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;

/** An event that a state of the new model defers waits until a state is entered that does not defer it. */
class DeferredEventsTest {
    private static final StateMachine MILL = StateMachine.named("original")
            .initial("Idle")
            .transition("Idle", "grind", "Grinding")
            .transition("Grinding", "stop", "Idle")
            .build();

    private final RecordingExecute mill = new RecordingExecute("Mill", "grind", "stop");
    private final PushMonitor panel = new PushMonitor("Panel");
    private final SystemEventConverter converter = new SystemEventConverter(
            LoopConfig.defaults("mill", new ManualClock()).withoutThreads());

    /** A mill that is cleaned first and does not grind meanwhile. */
    private static StateMachine evolved(boolean guarded) {
        var builder = StateMachine.named("new")
                .initial("Idle")
                .transition("Idle", "grind", "Grinding")
                .transition("Grinding", "stop", "Idle")
                .transition("Idle", "clean", "Cleaning")
                .transition("Cleaning", "cleaned", "Idle")
                .defers("Cleaning", new Event("grind"));
        if (guarded) {
            builder.transition(
                    new Transition(new State("Cleaning"), new Event("grind", List.of("urgent")), new State("Grinding")),
                    "");
        }
        return builder.build();
    }

    private void build(StateMachine evolved) {
        build(evolved, NewFunction.none());
    }

    private void build(StateMachine evolved, NewFunction cleaning) {
        converter.addMonitor(panel);
        converter.addExecute(mill);
        converter.addKnowledge(new StateKnowledge(new ModelPair(MILL, evolved)) {
            @Override
            protected void registerNewFunctions() {
                function("Cleaning", cleaning);
                if (evolved.guards().contains("urgent")) {
                    guard("urgent", () -> false);
                }
            }
        });
        converter.build();
        converter.start();
    }

    private void press(String event) throws InterruptedException {
        panel.press(event);
        converter.observe(panel);
        while (converter.step()) {
            converter.observe(panel);
        }
    }

    @Test
    void itWaitsAndOthersPassIt() throws InterruptedException {
        build(evolved(false));
        press("clean");
        press("grind");
        assertThat(mill.sent()).isEmpty();
        assertThat(converter.status().queue().depth()).isEqualTo(1);
        assertThat(converter.knowledge().configuration()).hasToString("(Idle, Cleaning)");

        press("cleaned");
        assertThat(mill.sent()).containsExactly("grind");
        assertThat(converter.knowledge().configuration()).hasToString("(Grinding, Grinding)");
        assertThat(converter.history())
                .extracting(entry -> entry.occurrence().label())
                .containsExactly("clean", "cleaned", "grind");
        converter.close();
    }

    @Test
    void howeverManyWaitTheOneThatEndsTheWaitHasAPlace() throws InterruptedException {
        build(evolved(false));
        press("clean");
        for (int count = 0; count < 8; count++) {
            press("grind");
        }
        assertThatThrownBy(() -> press("grind")).hasMessageContaining("has a full queue");
        assertThat(converter.status().queue().dropped()).as("the ninth").isEqualTo(1);

        press("cleaned");
        assertThat(converter.knowledge().configuration()).hasToString("(Grinding, Grinding)");
        assertThat(converter.status().queue().dropped()).isEqualTo(1);
        assertThat(converter.status().queue().depth()).isZero();
        converter.close();
    }

    /** It would wait until the state has been left, and be stale then. */
    @Test
    void theFunctionOfTheStateCannotRaiseIt() throws InterruptedException {
        List<String> refused = new ArrayList<>();
        build(evolved(false), visit -> {
            for (Executable raising : List.<Executable>of(
                    () -> visit.raise("grind"),
                    () -> visit.finish("grind"),
                    () -> visit.finishAfter(Duration.ofSeconds(1), "grind"),
                    () -> visit.finishAt(LocalTime.NOON, "grind"))) {
                refused.add(
                        assertThrows(IllegalArgumentException.class, raising).getMessage());
            }
            visit.finish("cleaned");
        });
        press("clean");
        assertThat(refused)
                .hasSize(4)
                .containsOnly("Cleaning defers grind, so that its own function cannot raise it: it would wait for "
                        + "another state, where it is too late");
        assertThat(converter.knowledge().configuration()).hasToString("(Idle, Idle)");
        assertThat(converter.history()).hasSize(2);
        converter.close();
    }

    @Test
    void unlessAGuardHoldsIsRefused() {
        assertThatThrownBy(() -> build(evolved(true)))
                .isInstanceOf(ModelException.class)
                .hasMessageContaining("the new model defers grind in Cleaning unless a guard holds");
    }
}
