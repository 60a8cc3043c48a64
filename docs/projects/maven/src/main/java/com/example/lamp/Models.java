package com.example.lamp;

import org.evoloop.evolution.ModelPair;
import org.evoloop.statemachine.StateMachine;

/** The lamp as it is and as it should be, without any file. */
final class Models {
    private Models() {}

    static ModelPair lamp() {
        StateMachine original = StateMachine.named("lamp")
                .initial("off")
                .transition("off", "switch", "on")
                .transition("on", "switch", "off")
                .build();
        StateMachine evolved = StateMachine.named("lamp with a second light")
                .initial("off")
                .transition("off", "switch", "on")
                .transition("on", "switch", "wait")
                .transition("wait", "timeout", "off")
                .transition("wait", "switch", "warm")
                .transition("warm", "switch", "off")
                .build();
        return new ModelPair(original, evolved);
    }
}
