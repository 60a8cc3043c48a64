package org.evoloop.converter;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.util.List;
import java.util.Set;
import org.evoloop.PaperModels;
import org.evoloop.RecordingExecute;
import org.evoloop.evolution.ModelPair;
import org.evoloop.function.NewFunction;
import org.evoloop.loop.LoopConfig;
import org.evoloop.loop.LoopState;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.ModelException;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.time.ManualClock;
import org.junit.jupiter.api.Test;

/** What {@link SystemEventConverter#build} refuses, all errors in one message. */
class ConverterBuildTest {
    private final SystemEventConverter converter = new SystemEventConverter(
            LoopConfig.defaults("robot", new ManualClock()).withoutThreads());

    /**
     * Knowledge whose functions are registered from outside, which these tests can do because they are in its package.
     */
    private static StateKnowledge complete(ModelPair pair) {
        StateKnowledge knowledge = new StateKnowledge(pair);
        knowledge.function("Move", NewFunction.none());
        knowledge.function("SpotWait", NewFunction.none());
        return knowledge;
    }

    @Test
    void namesEverythingThatIsMissing() {
        assertThatThrownBy(converter::build)
                .isInstanceOf(IllegalStateException.class)
                .hasMessage("converter robot: no knowledge, call addKnowledge; no execute component, call addExecute");
        converter.addKnowledge(complete(PaperModels.cleaningRobot()));
        assertThatThrownBy(converter::build)
                .isInstanceOf(IllegalStateException.class)
                .hasMessage("converter robot: no execute component, call addExecute");
        converter.addExecute(new RecordingExecute("Device", "Clean", "Spot"));
        converter.build();
        assertThat(converter.status().loop()).isEqualTo(LoopState.STOPPED);
        assertThatThrownBy(converter::build)
                .isInstanceOf(IllegalStateException.class)
                .hasMessage("converter robot has been built before");
    }

    @Test
    void isOfNoUseBeforeItIsBuilt() {
        for (Runnable use : List.<Runnable>of(
                converter::start, converter::stop, converter::status, converter::history, converter::knowledge)) {
            assertThatThrownBy(use::run)
                    .isInstanceOf(IllegalStateException.class)
                    .hasMessage("converter robot is not built yet");
        }
        converter.close();
    }

    @Test
    void refusesOptionsThatAreOutOfRange() {
        SystemEventConverter wrong = new SystemEventConverter(LoopConfig.defaults("robot", new ManualClock())
                .withQueueCapacity(-1)
                .withJoinLimit(Duration.ZERO));
        wrong.addKnowledge(complete(PaperModels.cleaningRobot()));
        wrong.addExecute(new RecordingExecute("Device", "Clean", "Spot"));
        assertThatThrownBy(wrong::build)
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage(
                        "queueCapacity is -1, allowed is 0 to 1000000; joinLimit is PT0S, allowed is 1 ms to 1 min");
    }

    @Test
    void refusesSecondKnowledgeAndASecondComponentOfTheSameName() {
        converter.addKnowledge(complete(PaperModels.cleaningRobot()));
        assertThatThrownBy(() -> converter.addKnowledge(complete(PaperModels.cleaningRobot())))
                .isInstanceOf(IllegalStateException.class)
                .hasMessage("there is knowledge already, StateKnowledge");
        converter.addExecute(new RecordingExecute("Device", "Clean"));
        assertThatThrownBy(() -> converter.addExecute(new RecordingExecute("Device", "Spot")))
                .isInstanceOf(IllegalStateException.class)
                .hasMessage("there is a component named Device already; give one of them another name");
    }

    @Test
    void namesEveryViolationOfTheTwoConditions() {
        ModelPair torn = new ModelPair(
                StateMachine.named("original")
                        .initial("Off")
                        .transition("Off", "Clean", "On")
                        .transition("On", "Spot", "Spot")
                        .build(),
                StateMachine.named("new")
                        .initial("Idle")
                        .transition("Idle", "Clean", "On")
                        .transition("On", "Dock", "Docked")
                        .build());
        assertThatThrownBy(() -> new StateKnowledge(torn))
                .isInstanceOf(ModelException.class)
                .hasMessage("the models 'original' and 'new' are not an evolution: "
                        + "Condition 1: event Spot is missing in the new model; "
                        + "Condition 2: state Off is missing in the new model; "
                        + "Condition 2: state Spot is missing in the new model; "
                        + "the new model starts in Idle, the device in Off. "
                        + "The new model must keep every state and event of the device; names are case-sensitive");
    }

    @Test
    void namesEverythingThatDoesNotFitInOneMessage() {
        StateKnowledge knowledge = new StateKnowledge(PaperModels.cleaningRobot());
        knowledge.function("Dance", NewFunction.none());
        knowledge.function("Clean", NewFunction.none());
        knowledge.timer("Clean", "timeout", Duration.ofSeconds(1));
        knowledge.timer("SpotWait", "timeout", Duration.ofSeconds(-1));
        knowledge.putTransition("On", "Dance", NewFunction.none(), "Spot");
        knowledge.putTransition("On", "Clean", NewFunction.none(), "Clean");
        converter.addKnowledge(knowledge);
        converter.addMonitor(new PushMonitor("Panel") {
            @Override
            protected Set<String> spontaneousEvents() {
                return Set.of("Dock");
            }
        });
        converter.addExecute(new RecordingExecute("Device", "Clean", "Max"));

        assertThatThrownBy(converter::build)
                .isInstanceOf(ModelException.class)
                .satisfies(refusal -> assertThat(
                                String.valueOf(refusal.getMessage()).lines())
                        .containsExactlyInAnyOrder(
                                "a function is registered for Dance, which is not a state of the new model; there is Clean, "
                                        + "Move, Off, On, Spot, SpotWait",
                                "a function is registered for Clean, but the device itself has that state",
                                "a timer raises timeout in Clean, where the new model has no transition for it",
                                "the timer that raises timeout in SpotWait has the delay PT-1S, allowed is 0 to 36500 days",
                                "an action is registered for On --Spot--> Dance, which the new model does not have",
                                "an action is registered for On --Clean--> Clean, but its target is a state of the "
                                        + "device",
                                "new state Move has no function: register one in registerNewFunctions, "
                                        + "NewFunction.none() if nothing has to run",
                                "the model 'new' cannot be carried out:",
                                "  Device can send Max, which is not an event of the original model 'original'; there is "
                                        + "Clean, Spot, endSpot",
                                "  Panel names as the device's own Dock, which is not an event of the original model "
                                        + "'original'; there is Clean, Spot, endSpot",
                                "  event Spot of the original model can be sent by no execute component and is not declared "
                                        + "to be the device's own; name it in sendableEvents, or in spontaneousEvents of "
                                        + "a monitor",
                                "  no plan in (Clean, SpotWait): event Clean leads to Spot, but with the device in "
                                        + "Clean no events that can be sent take it there (sendable: Clean, Max)"));
    }

    @Test
    void canBeCorrectedAndBuiltAfterItWasRefused() {
        StateKnowledge knowledge = new StateKnowledge(PaperModels.cleaningRobot());
        knowledge.function("Move", NewFunction.none());
        converter.addKnowledge(knowledge);
        converter.addExecute(new RecordingExecute("Device", "Clean", "Spot"));
        assertThatThrownBy(converter::build).hasMessageContaining("new state SpotWait has no function");
        knowledge.function("SpotWait", NewFunction.none());
        converter.build();
        converter.start();
        assertThat(converter.status().loop()).isEqualTo(LoopState.RUNNING);
        converter.close();
    }

    @Test
    void aTimerOrAnActionOnEveryWayInIsAsGoodAsAFunction() {
        StateKnowledge knowledge = new StateKnowledge(PaperModels.cleaningRobot());
        knowledge.timer("SpotWait", "timeout", Duration.ofSeconds(5));
        knowledge.putTransition("On", "Move", NewFunction.none(), "Spot");
        converter.addKnowledge(knowledge);
        converter.addExecute(new RecordingExecute("Device", "Clean", "Spot"));
        converter.build();
        assertThat(converter
                        .knowledge()
                        .getTransition(knowledge.models().original().initial(), event("Spot")))
                .isEmpty();
    }

    private static Event event(String name) {
        return new Event(name);
    }

    @Test
    void aGuardThatIsDrawnInCodeHasToBeBoundToo() {
        StateMachine lamp = StateMachine.named("lamp")
                .initial("Off")
                .transition("Off", "switch", "On")
                .transition("On", "switch", "Off")
                .build();
        StateMachine evolved = StateMachine.named("new")
                .initial("Off")
                .transition("Off", "switch [dark]", "On")
                .transition("On", "switch", "Off")
                .build();
        try (SystemEventConverter converter =
                new SystemEventConverter(LoopConfig.defaults("lamp", new ManualClock()))) {
            converter.addExecute(new RecordingExecute("Lamp", "switch"));
            converter.addKnowledge(new StateKnowledge(new ModelPair(lamp, evolved)));
            assertThatThrownBy(converter::build)
                    .hasMessageContaining(
                            "guard [dark] of the new model is not bound: call guard in registerNewFunctions");
        }
    }
}
