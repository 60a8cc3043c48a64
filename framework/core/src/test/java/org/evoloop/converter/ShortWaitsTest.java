package org.evoloop.converter;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;

import java.time.Duration;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Step;
import org.evoloop.function.StatePatternFunction;
import org.evoloop.loop.LoopConfig;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.time.ManualClock;
import org.evoloop.time.SystemClock;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Sub-states and execute components let time pass, with threads and without. */
@Timeout(20)
class ShortWaitsTest {
    private static final StateMachine PUMP = StateMachine.named("pump")
            .initial("Off")
            .transition("Off", "power", "On")
            .transition("On", "power", "Off")
            .build();

    private static final StateMachine RINSING = StateMachine.named("rinsing")
            .initial("Off")
            .transition("Off", "power", "On")
            .transition("On", "power", "Off")
            .transition("Off", "rinse", "Rinsing")
            .transition("Rinsing", "rinsed", "Off")
            .transition("Rinsing", "cancel", "Off")
            .build();

    private final List<String> parts = new CopyOnWriteArrayList<>();
    private final PushMonitor panel = new PushMonitor("Panel");

    private static final class Relay extends EventExecute {
        @Override
        protected Set<String> sendableEvents() {
            return Set.of("power");
        }

        @Override
        protected void send(Step step) throws InterruptedException {
            sleep(Duration.ofMillis(1));
        }

        long now() {
            return clock().nanoTime();
        }
    }

    private SystemEventConverter start(LoopConfig config) {
        SystemEventConverter converter = new SystemEventConverter(config);
        converter.addMonitor(panel);
        converter.addExecute(new Relay());
        converter.addKnowledge(new StateKnowledge(new ModelPair(PUMP, RINSING)) {
            @Override
            protected void registerNewFunctions() {
                function("Rinsing", new StatePatternFunction(visit -> {
                    parts.add("fill");
                    visit.onEnd(() -> parts.add("stop"));
                    return StatePatternFunction.after(Duration.ofMillis(30), full -> {
                        parts.add("drain");
                        return StatePatternFunction.after(Duration.ofMillis(20), empty -> {
                            empty.finish("rinsed");
                            return null;
                        });
                    });
                }));
            }
        });
        converter.build();
        converter.start();
        return converter;
    }

    @Test
    void aTestWithoutThreadsMovesTheClock() {
        ManualClock clock = new ManualClock();
        try (SystemEventConverter converter =
                start(LoopConfig.defaults("pump", clock).withoutThreads())) {
            panel.press("rinse");
            assertThat(converter.step()).isTrue();
            assertThat(parts).containsExactly("fill");
            clock.advance(Duration.ofMillis(29));
            assertThat(parts).containsExactly("fill");
            clock.advance(Duration.ofMillis(1));
            assertThat(parts).containsExactly("fill", "drain");
            clock.advance(Duration.ofMillis(20));
            assertThat(converter.step()).isTrue();
            assertThat(parts).containsExactly("fill", "drain", "stop");
            assertThat(converter.knowledge().configuration()).hasToString("(Off, Off)");

            panel.press("rinse");
            panel.press("cancel");
            assertThat(converter.step()).isTrue();
            assertThat(converter.step()).isTrue();
            clock.advance(Duration.ofSeconds(9));
            assertThat(parts).as("the sub-state ends with its visit").endsWith("fill", "stop");

            panel.press("power");
            assertThat(converter.step()).isTrue();
            assertThat(converter.knowledge().configuration()).hasToString("(On, On)");
        }
    }

    @Test
    void withThreadsTheyWait() throws Exception {
        try (SystemClock clock = new SystemClock();
                SystemEventConverter converter = start(LoopConfig.defaults("pump", clock))) {
            assertThat(panel.submit("rinse").get().isHandled()).isTrue();
            LiveRobot.until(() -> parts.equals(List.of("fill", "drain", "stop"))
                    && converter.status().events().handled() == 2);
            assertThat(panel.submit("power").get().isHandled()).isTrue();
        }
    }

    @Test
    void aComponentWithoutConverterHasNoClock() {
        assertThatIllegalStateException()
                .isThrownBy(() -> new Relay().now())
                .withMessage("Relay is not part of a converter yet, so it has no clock");
    }
}
