package org.evoloop.journal;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.evoloop.engine.Rules;
import org.evoloop.evolution.DecisionTable;
import org.evoloop.evolution.DeviceEvents;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.OnFailure;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.StateMachineBuilder;
import org.evoloop.statemachine.Transition;

/** The paper's cleaning robot, with a beep when it begins to clean and a new state that takes two events to leave. */
final class Robot {
    static final ModelPair MODELS = models("original", "Clean");
    static final Rules RULES = rules(MODELS, 8);

    private Robot() {}

    /**
     * @param name of the original model
     * @param first what turns it on
     */
    static ModelPair models(String name, String first) {
        StateMachineBuilder evolved = StateMachine.named("new")
                .initial("Off")
                .transition("Off", "Clean", "On")
                .transition("On", "Spot", "Move")
                .transition("Move", "arriveSpot", "Spot")
                .transition("Spot", "endSpot", "On")
                .transition("Clean", "Clean", "SpotWait")
                .transition("SpotWait", "timeout", "On")
                .transition("SpotWait", "Clean", "Spot");
        evolved.transition(
                new Transition(new State("On"), new Event("Clean"), new State("Clean"), List.of("beep"), false), "");
        return new ModelPair(
                StateMachine.named(name)
                        .initial("Off")
                        .transition("Off", first, "On")
                        .transition("On", "Clean", "Clean")
                        .transition("On", "Spot", "Spot")
                        .transition("Clean", "Clean", "On")
                        .transition("Spot", "endSpot", "On")
                        .spontaneous("endSpot")
                        .build(),
                evolved.build());
    }

    /** A robot that returns to On after cleaning, without waiting in between. */
    static ModelPair withoutSpotWait() {
        StateMachineBuilder evolved = StateMachine.named("direct")
                .initial("Off")
                .transition("Off", "Clean", "On")
                .transition("On", "Spot", "Move")
                .transition("Move", "arriveSpot", "Spot")
                .transition("Spot", "endSpot", "On")
                .transition("Clean", "Clean", "On");
        evolved.transition(
                new Transition(new State("On"), new Event("Clean"), new State("Clean"), List.of("beep"), false), "");
        return new ModelPair(MODELS.original(), evolved.build());
    }

    /** A robot that moves while it cleans: a robot that moves otherwise has to be sent there. */
    static ModelPair movingInClean() {
        return new ModelPair(
                MODELS.original(),
                StateMachine.named("busy")
                        .initial("Off")
                        .transition("Off", "Clean", "On")
                        .transition("On", "Clean", "Clean")
                        .transition("On", "Spot", "Spot")
                        .transition("Clean", "Clean", "On")
                        .transition("Clean", "Spot", "Move")
                        .transition("Move", "arriveSpot", "On")
                        .transition("Spot", "endSpot", "On")
                        .build());
    }

    static Rules rules(ModelPair models, int queueCapacity) {
        DeviceEvents device = new DeviceEvents(
                        Set.of(new Event("Clean"), new Event("Spot")), Set.of(new Event("endSpot")))
                .withCosts(Map.of(new Event("Spot"), 2))
                .withOnFailure(Map.of(new State("SpotWait"), Map.of("Clean", OnFailure.GO_BACK)));
        return new Rules(
                DecisionTable.compile(models, device),
                state -> state.name().equals("SpotWait")
                        ? Map.of(new Event("timeout"), Duration.ofSeconds(5))
                        : Map.of(),
                queueCapacity);
    }
}
