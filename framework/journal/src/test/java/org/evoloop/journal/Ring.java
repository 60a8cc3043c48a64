package org.evoloop.journal;

import org.evoloop.converter.StateKnowledge;
import org.evoloop.evolution.ModelPair;
import org.evoloop.function.NewFunction;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.StateMachineBuilder;

/** A device that goes round from A to B to C, and a new model in which one event takes it two steps further. */
final class Ring extends StateKnowledge {
    static final ModelPair MODELS = new ModelPair(
            StateMachine.named("original")
                    .initial("A")
                    .transition("A", "next", "B")
                    .transition("B", "next", "C")
                    .transition("C", "next", "A")
                    .build(),
            round("new").build());

    /** The same with one more state. */
    static final ModelPair LARGER = new ModelPair(
            MODELS.original(),
            round("larger")
                    .transition("A", "rest", "Rest")
                    .transition("Rest", "next", "B")
                    .build());

    private static StateMachineBuilder round(String name) {
        return StateMachine.named(name)
                .initial("A")
                .transition("A", "next", "B")
                .transition("B", "next", "C")
                .transition("C", "next", "A")
                .transition("A", "skip", "C")
                .transition("B", "skip", "A")
                .transition("C", "skip", "B");
    }

    Ring(ModelPair models) {
        super(models);
    }

    @Override
    protected void registerNewFunctions() {
        if (models().evolved().hasState(new State("Rest"))) {
            function("Rest", NewFunction.none());
        }
    }
}
