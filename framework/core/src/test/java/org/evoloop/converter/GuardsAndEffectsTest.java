package org.evoloop.converter;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.evoloop.Machines.machine;

import java.io.IOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.function.Consumer;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Outcome;
import org.evoloop.evolution.Step;
import org.evoloop.evolution.Values;
import org.evoloop.function.NewFunction;
import org.evoloop.loop.LoopConfig;
import org.evoloop.statemachine.ModelException;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.time.ManualClock;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** Guards, effects and internal transitions in a running converter. */
class GuardsAndEffectsTest {
    private final ManualClock clock = new ManualClock();
    private final Set<String> holding = new HashSet<>();
    private final List<String> log = new ArrayList<>();
    private final Set<String> spontaneous = new HashSet<>();
    private final Panel panel = new Panel();
    private final SystemEventConverter converter =
            new SystemEventConverter(LoopConfig.defaults("lamp", clock).withoutThreads());
    private boolean cableIsOut;

    private final class Panel extends PushMonitor {
        private void does(String event) {
            push(fromDevice(event));
        }

        @Override
        protected Set<String> spontaneousEvents() {
            return spontaneous;
        }
    }

    @AfterEach
    void close() {
        converter.close();
    }

    private void run(StateMachine original, StateMachine evolved, Consumer<StateKnowledge> registering) {
        converter.addMonitor(panel);
        converter.addKnowledge(new StateKnowledge(new ModelPair(original, evolved)) {
            @Override
            protected void registerNewFunctions() {
                registering.accept(this);
            }
        });
        Set<String> sendable = new HashSet<>();
        original.triggers().forEach(event -> sendable.add(event.name()));
        sendable.remove("own");
        converter.addExecute(new EventExecute("Device") {
            @Override
            protected Set<String> sendableEvents() {
                return sendable;
            }

            @Override
            protected void send(Step step) throws IOException {
                if (cableIsOut) {
                    throw new IOException("the cable is out");
                }
                log.add("sent " + step.event().name());
            }
        });
        converter.build();
        converter.start();
    }

    private void bind(StateKnowledge knowledge, String... guards) {
        for (String guard : guards) {
            knowledge.guard(guard, () -> holding.contains(guard));
        }
    }

    private void bindEffects(StateKnowledge knowledge, String... effects) {
        for (String effect : effects) {
            knowledge.effect(effect, () -> log.add(effect));
        }
    }

    private String press(String event) throws InterruptedException {
        panel.press(event);
        converter.observe(panel);
        converter.step();
        return converter.knowledge().configuration().toString();
    }

    private HistoryEntry last() {
        return converter.history().get(converter.history().size() - 1);
    }

    private static final StateMachine LAMP = machine("original", "Off press -> On", "On press -> Off");

    @Test
    void theFirstTransitionWhoseGuardsAllHoldCounts() throws InterruptedException {
        StateMachine evolved = machine(
                "new",
                "Off press -> On",
                "On press [hot] [full] -> Alarm",
                "On press [hot] -> Cool",
                "On press -> Off",
                "Alarm press -> Off",
                "Cool press -> Off");
        run(LAMP, evolved, knowledge -> {
            bind(knowledge, "hot", "full");
            knowledge.function("Alarm", NewFunction.none());
            knowledge.function("Cool", NewFunction.none());
        });
        press("press");
        assertThat(press("press")).isEqualTo("(Off, Off)");
        press("press");
        holding.add("full");
        assertThat(press("press")).isEqualTo("(Off, Off)");
        press("press");
        holding.add("hot");
        assertThat(press("press")).isEqualTo("(On, Alarm)");
        press("press");
        press("press");
        holding.remove("full");
        assertThat(press("press")).isEqualTo("(On, Cool)");
    }

    @Test
    void anEventWhoseGuardsDoNotHoldIsNotAcceptable() throws InterruptedException {
        run(
                LAMP,
                machine("new", "Off press -> On", "On press -> Off", "On wait [hot] -> Off"),
                knowledge -> bind(knowledge, "hot"));
        press("press");
        assertThat(press("wait")).isEqualTo("(On, On)");
        assertThat(last().outcome()).isEqualTo(Outcome.IGNORED);
        holding.add("hot");
        assertThat(press("wait")).isEqualTo("(Off, Off)");
    }

    @Test
    void aGuardThatThrowsMakesTheEventFail() throws InterruptedException {
        run(
                LAMP,
                machine("new", "Off press [hot] -> On", "On press -> Off", "Off press -> Off"),
                knowledge -> knowledge.guard("hot", () -> {
                    throw new IllegalStateException("no thermometer");
                }));
        assertThat(press("press")).isEqualTo("(Off, Off)");
        assertThat(last().outcome()).isEqualTo(Outcome.FAILED);
        assertThat(last().detail()).contains("no thermometer");
    }

    @Test
    void effectsRunInOrderAfterTheDeviceHasObeyed() throws InterruptedException {
        run(
                LAMP,
                machine("new", "Off press -> On / beep, blink", "On press -> Off"),
                knowledge -> bindEffects(knowledge, "beep", "blink"));
        press("press");
        assertThat(log).containsExactly("sent press", "beep", "blink");
    }

    @Test
    void effectsDoNotRunWhenTheDeviceDidNotObey() throws InterruptedException {
        run(
                LAMP,
                machine("new", "Off press -> On / beep", "On press -> Off"),
                knowledge -> bindEffects(knowledge, "beep"));
        cableIsOut = true;
        assertThat(press("press")).isEqualTo("(Off, Off)");
        assertThat(log).isEmpty();
    }

    @Test
    void whatTheDeviceDoesByItselfIsNotDoneTwiceAndNeedsNoBinding() throws InterruptedException {
        run(
                machine("original", "Off press -> On / light", "On press -> Off"),
                machine("new", "Off press -> On / light, beep", "On press -> Off"),
                knowledge -> bindEffects(knowledge, "beep"));
        press("press");
        assertThat(log).containsExactly("sent press", "beep");
    }

    @Test
    void anEffectThatFailsIsReportedAndTheTransitionIsTaken() throws InterruptedException {
        run(LAMP, machine("new", "Off press -> On / beep, blink", "On press -> Off"), knowledge -> {
            knowledge.effect("beep", () -> {
                throw new IOException("no buzzer");
            });
            bindEffects(knowledge, "blink");
        });
        assertThat(press("press")).isEqualTo("(On, On)");
        assertThat(log).containsExactly("sent press", "blink");
        assertThat(last().outcome()).isEqualTo(Outcome.FAILED);
        assertThat(last().detail()).isEqualTo("Device.effect beep: no buzzer");
    }

    @Test
    void anEffectThatIsInterruptedEndsThePlanAndTheTransitionIsTaken() throws InterruptedException {
        BlockingQueue<Values> seen = new LinkedBlockingQueue<>();
        run(LAMP, machine("new", "Off press -> On", "On press -> Off", "Off dim -> Dim / beep, blink"), knowledge -> {
            knowledge.effect("beep", () -> {
                throw new InterruptedException("the program ends");
            });
            bindEffects(knowledge, "blink");
            knowledge.function("Dim", visit -> seen.add(visit.values()));
        });
        panel.press("dim", Values.of("percent", 40));
        converter.observe(panel);
        converter.step();

        assertThat(LiveRobot.take(seen)).isEqualTo(Values.of("percent", 40));
        assertThat(converter.knowledge().configuration()).hasToString("(Off, Dim)");
        assertThat(last().outcome()).isEqualTo(Outcome.FAILED);
        assertThat(last().detail())
                .isEqualTo("it is unknown whether the effect beep was run: Device.execute: the program ends;"
                        + " the effect blink was not run: Device.execute: the program ends");
        assertThat(log).isEmpty();
    }

    @Test
    void anInternalTransitionRunsItsEffectsAndLeavesNothing() throws InterruptedException {
        run(
                LAMP,
                machine("new", "Off press -> On", "On press -> Wait", "Wait count => Wait / beep", "Wait end -> Off"),
                knowledge -> {
                    bindEffects(knowledge, "beep");
                    knowledge.function("Wait", visit -> {
                        log.add("begins");
                        visit.onEnd(() -> log.add("ends"));
                        visit.finishAfter(Duration.ofSeconds(5), "end");
                    });
                });
        press("press");
        press("press");
        clock.advance(Duration.ofSeconds(3));
        assertThat(press("count")).isEqualTo("(On, Wait)");
        clock.advance(Duration.ofSeconds(2));
        converter.step();
        assertThat(log).containsExactly("sent press", "begins", "beep", "ends", "sent press");
    }

    @Test
    void aTimeTriggerUnderAGuardIsRaisedAndTheGuardDecides() throws InterruptedException {
        run(
                LAMP,
                machine("new", "Off press -> On", "On press -> Wait", "Wait tm(2s) [hot] -> Off", "Wait tm(2s) -> On"),
                knowledge -> bind(knowledge, "hot"));
        press("press");
        press("press");
        holding.add("hot");
        clock.advance(Duration.ofSeconds(2));
        converter.step();
        assertThat(converter.knowledge().configuration()).hasToString("(Off, Off)");
    }

    @Test
    void aGuardOfTheDeviceIsAskedWhenItsEventIsAboutToBeSent() throws InterruptedException {
        StateMachine original = machine("original", "Off press [dark] -> On", "On press -> Off");
        StateMachine evolved =
                machine("new", "Off press [dark] -> On", "On press -> Off", "Off glow -> Warm", "Warm up -> On");
        run(original, evolved, knowledge -> {
            bind(knowledge, "dark");
            knowledge.function("Warm", NewFunction.none());
        });
        press("glow");
        assertThat(press("up")).isEqualTo("(Off, Warm)");
        assertThat(last().outcome()).isEqualTo(Outcome.FAILED);
        assertThat(last().detail())
                .contains("the guards of the original model do not let Off --press [dark]--> On be taken now");
        holding.add("dark");
        assertThat(press("up")).isEqualTo("(On, On)");
    }

    @Test
    void theDevicesOwnGuardedStepIsFollowedWhereTheNewModelHasNone() throws InterruptedException {
        StateMachine original =
                machine("original", "Off press -> On", "On press -> Off", "On own [hot] -> Off", "On own -> Off");
        StateMachine evolved = machine(
                "new",
                "Off press -> On",
                "On press -> Wait",
                "Wait press -> Off",
                "On own [hot] -> Off",
                "On own -> Off");
        spontaneous.add("own");
        run(original, evolved, knowledge -> {
            bind(knowledge, "hot");
            knowledge.function("Wait", NewFunction.none());
        });
        press("press");
        press("press");
        panel.does("own");
        converter.observe(panel);
        converter.step();
        assertThat(converter.knowledge().configuration()).hasToString("(Off, Wait)");
    }

    @Test
    void anActionIsRegisteredForAGuardedTransitionByItsLabel() throws InterruptedException {
        run(
                LAMP,
                machine(
                        "new",
                        "Off press -> On",
                        "On press [hot] -> Wait",
                        "On press -> Wait",
                        "Wait press -> Off / beep"),
                knowledge -> {
                    bind(knowledge, "hot");
                    bindEffects(knowledge, "beep");
                    knowledge.putTransition("On", "Wait", visit -> log.add("plain"), "press");
                    knowledge.putTransition("On", "Wait", visit -> log.add("hot"), "press [hot]");
                });
        press("press");
        press("press");
        press("press");
        press("press");
        holding.add("hot");
        press("press");
        assertThat(log).containsExactly("sent press", "plain", "sent press", "beep", "sent press", "hot");
    }

    @Test
    void refusesWhatIsNotBoundAndWhatIsBoundToNothing() {
        StateMachine evolved = machine("new", "Off press [hot] -> On / beep", "On press -> Off", "!press");
        assertThatThrownBy(() -> run(LAMP, evolved, knowledge -> {
                    bind(knowledge, "cold");
                    bindEffects(knowledge, "blink");
                    knowledge.cost("Dance", 2);
                    knowledge.doNotPass("Hall");
                }))
                .isInstanceOf(ModelException.class)
                .satisfies(refusal -> assertThat(
                                String.valueOf(refusal.getMessage()).lines())
                        .containsExactlyInAnyOrder(
                                "guard [cold] is bound, but drawn in neither model",
                                "guard [hot] of the new model is not bound: call guard in registerNewFunctions",
                                "effect blink is bound, but the new model does not draw it",
                                "a cost is given to Dance, which is not an event of the original model; there is press",
                                "Hall is not to be passed, but is not a state of the original model; there is Off, On",
                                "the model 'new' cannot be carried out:",
                                "  effect beep of the new model is not bound: call effect in registerNewFunctions"));
    }

    @Test
    void plansObeyCostsAndStatesThatMustNotBePassed() throws InterruptedException {
        StateMachine original = machine(
                "original",
                "On Clean -> Clean",
                "Clean Stop -> Spot",
                "On Max -> Max",
                "Max Slow -> Clean",
                "Max Back -> Spot",
                "Spot Stop -> On");
        StateMachine evolved = machine(
                "new",
                "On Clean -> Clean",
                "Clean Stop -> Spot",
                "On Max -> Max",
                "Max Slow -> Clean",
                "Max Back -> Spot",
                "Spot Stop -> On",
                "On go -> Move",
                "Move arrive -> Spot");
        run(original, evolved, knowledge -> {
            knowledge.function("Move", NewFunction.none());
            knowledge.doNotPass("Clean");
            knowledge.cost("Back", 9);
        });
        press("go");
        press("arrive");
        assertThat(log).containsExactly("sent Max", "sent Back");
    }
}
