package org.evoloop.converter;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import java.util.Set;
import org.evoloop.Machines;
import org.evoloop.RecordingExecute;
import org.evoloop.evolution.ModelPair;
import org.evoloop.function.NewFunction;
import org.evoloop.loop.LoopConfig;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.StateMachineBuilder;
import org.evoloop.statemachine.Transition;
import org.evoloop.time.ManualClock;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** The timer of a composite state keeps running while the system moves between its substates. */
class KeptTimersTest {
    private final ManualClock clock = new ManualClock();
    private final PushMonitor panel = new PushMonitor("Panel") {};
    private final SystemEventConverter converter =
            new SystemEventConverter(LoopConfig.defaults("lamp", clock).withoutThreads());

    @BeforeEach
    void build() {
        // Red and Blue are in a composite state that is left 10 s after it was entered; Blue has its own timer.
        StateMachineBuilder evolved = StateMachine.named("new")
                .initial("Off")
                .transition("Off", "press", "Red")
                .transition("Red", "tm(10s)", "Off")
                .transition("Blue", "tm(10s)", "Off")
                .transition("Red", "leave", "Off");
        evolved.transition(inside("Red", "change", "Blue"), "");
        evolved.transition(inside("Blue", "tm(3s)", "Red"), "");
        converter.addKnowledge(
                new StateKnowledge(new ModelPair(Machines.machine("original", "Off press -> Off"), evolved.build())) {
                    @Override
                    protected void registerNewFunctions() {
                        function("Red", NewFunction.none());
                        function("Blue", NewFunction.none());
                    }
                });
        converter.addMonitor(panel);
        converter.addExecute(new RecordingExecute("Device", "press"));
        converter.build();
        converter.start();
    }

    private static Transition inside(String source, String event, String target) {
        return new Transition(
                new State(source), new Event(event), new State(target), List.of(), false, Set.of("tm(10s)"));
    }

    @AfterEach
    void close() {
        converter.close();
    }

    private String state() {
        return converter.knowledge().getCurrentState().name();
    }

    private void press(String event) throws InterruptedException {
        panel.press(event);
        converter.observe(panel);
        converter.step();
    }

    private void pass(int seconds) {
        clock.advance(Duration.ofSeconds(seconds));
        converter.step();
    }

    @Test
    void itFiresAfterTheTimeSinceTheStateAroundWasEntered() throws InterruptedException {
        press("press");
        pass(6);
        press("change");
        pass(3);
        assertThat(state()).isEqualTo("Red");
        pass(1);
        assertThat(state()).isEqualTo("Off");
    }

    @Test
    void itStartsAnewWhenTheStateAroundIsEnteredAnew() throws InterruptedException {
        press("press");
        pass(6);
        press("leave");
        press("press");
        pass(6);
        assertThat(state()).isEqualTo("Red");
        pass(4);
        assertThat(state()).isEqualTo("Off");
    }

    @Test
    void itIsNotLostWhenItFiresWhileAnotherEventMovesInside() throws InterruptedException {
        press("press");
        panel.press("change");
        converter.observe(panel);
        clock.advance(Duration.ofSeconds(10));
        converter.step();
        assertThat(state()).isEqualTo("Blue");
        converter.step();
        clock.advance(Duration.ZERO);
        while (converter.step()) {
            clock.advance(Duration.ZERO);
        }
        assertThat(state()).isEqualTo("Off");
    }
}
