package org.evoloop.check;

import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.StateMachineBuilder;

/** A lamp and its button, which tests give further states. */
public final class Lamp {
    private Lamp() {}

    public static StateMachineBuilder lamp(String name) {
        return StateMachine.named(name)
                .initial("Off")
                .transition("Off", "press", "On")
                .transition("On", "press", "Off");
    }
}
