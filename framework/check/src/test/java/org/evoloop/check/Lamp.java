package org.evoloop.check;

import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.StateMachineBuilder;

/** A lamp with a button, to which tests add states. */
public final class Lamp {
    private Lamp() {}

    public static StateMachineBuilder lamp(String name) {
        return StateMachine.named(name)
                .initial("Off")
                .transition("Off", "press", "On")
                .transition("On", "press", "Off");
    }
}
