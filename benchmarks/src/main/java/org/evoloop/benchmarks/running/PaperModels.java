package org.evoloop.benchmarks.running;

import org.evoloop.evolution.ModelPair;
import org.evoloop.statemachine.StateMachine;

/** The paper's cleaning robot, equal to {@code models/cleaning-robot.xml}, so that a forked JVM needs no file. */
public final class PaperModels {
    private PaperModels() {}

    /** The pair of models. */
    public static ModelPair cleaningRobot() {
        return new ModelPair(
                StateMachine.named("original")
                        .initial("Off")
                        .transition("Off", "Clean", "On")
                        .transition("On", "Clean", "Clean")
                        .transition("On", "Spot", "Spot")
                        .transition("Clean", "Clean", "On")
                        .transition("Spot", "endSpot", "On")
                        .build(),
                StateMachine.named("new")
                        .initial("Off")
                        .transition("Off", "Clean", "On")
                        .transition("On", "Spot", "Move")
                        .transition("On", "Clean", "Clean")
                        .transition("Move", "arriveSpot", "Spot")
                        .transition("Spot", "endSpot", "On")
                        .transition("Clean", "Clean", "SpotWait")
                        .transition("SpotWait", "timeout", "On")
                        .transition("SpotWait", "Clean", "Spot")
                        .build());
    }
}
