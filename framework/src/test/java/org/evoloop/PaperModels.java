package org.evoloop;

import org.evoloop.evolution.ModelPair;
import org.evoloop.statemachine.StateMachine;

/** The two pairs of the paper, written down for tests that need no file. */
public final class PaperModels {
    private PaperModels() {}

    public static ModelPair cleaningRobot() {
        return new ModelPair(
                StateMachine.named("original")
                        .initial("Off")
                        .transition("Off", "Clean", "On")
                        .transition("On", "Clean", "Clean")
                        .transition("On", "Spot", "Spot")
                        .transition("Clean", "Clean", "On")
                        .transition("Spot", "endSpot", "On")
                        .spontaneous("endSpot")
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

    public static ModelPair lightBulb() {
        return new ModelPair(
                StateMachine.named("original")
                        .initial("off")
                        .transition("off", "switch", "on")
                        .transition("on", "switch", "off")
                        .build(),
                StateMachine.named("new")
                        .initial("off")
                        .transition("off", "switch", "on")
                        .transition("on", "switch", "wait")
                        .transition("wait", "timeout", "off")
                        .transition("wait", "switch", "incandescentOn")
                        .transition("incandescentOn", "switch", "off")
                        .build());
    }
}
