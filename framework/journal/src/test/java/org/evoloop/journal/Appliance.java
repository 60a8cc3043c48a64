package org.evoloop.journal;

import java.util.Set;
import org.evoloop.converter.StateKnowledge;
import org.evoloop.evolution.ModelPair;
import org.evoloop.function.NewFunction;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.StateMachineBuilder;

/** Devices whose new models have a state that needs the device somewhere. Most events toggle something. */
enum Appliance {
    /** Stopped half-way for air; one button does everything. */
    SHUTTER("Airing", "HalfUp", "tap") {
        @Override
        StateMachineBuilder device(String name) {
            return StateMachine.named(name)
                    .initial("Down")
                    .transition("Down", "tap", "Rising")
                    .transition("Rising", "tap", "HalfUp")
                    .transition("Rising", "top", "Up")
                    .transition("HalfUp", "tap", "Falling")
                    .transition("Up", "tap", "Falling")
                    .transition("Falling", "tap", "HalfDown")
                    .transition("Falling", "bottom", "Down")
                    .transition("HalfDown", "tap", "Rising")
                    .spontaneous("top")
                    .spontaneous("bottom");
        }

        @Override
        StateMachineBuilder evolved() {
            return device("new")
                    .transition("Down", "extra", "Airing")
                    .transition("Up", "extra", "Airing")
                    .transition("HalfDown", "extra", "Airing")
                    .transition("Airing", "tap", "Falling")
                    .transition("Airing", "extra", "Rising");
        }
    },
    /** Heated for somebody who waits. */
    KETTLE("Tea", "Heating", "power") {
        @Override
        StateMachineBuilder device(String name) {
            return StateMachine.named(name)
                    .initial("Off")
                    .transition("Off", "power", "Heating")
                    .transition("Heating", "power", "Off")
                    .transition("Heating", "hot", "Ready")
                    .transition("Ready", "power", "Off")
                    .spontaneous("hot");
        }

        @Override
        StateMachineBuilder evolved() {
            return device("new")
                    .transition("Off", "extra", "Tea")
                    .transition("Heating", "extra", "Tea")
                    .transition("Ready", "extra", "Tea")
                    .transition("Tea", "hot", "Ready")
                    .transition("Tea", "power", "Off");
        }
    },
    /** Turbo, and then the mode before. */
    AIR_CONDITIONER("Boost", "Turbo", "power", "mode", "turbo") {
        @Override
        StateMachineBuilder device(String name) {
            return StateMachine.named(name)
                    .initial("Off")
                    .transition("Off", "power", "Cool")
                    .transition("Cool", "power", "Off")
                    .transition("Cool", "mode", "Dry")
                    .transition("Cool", "turbo", "Turbo")
                    .transition("Dry", "power", "Off")
                    .transition("Dry", "mode", "Cool")
                    .transition("Dry", "turbo", "Turbo")
                    .transition("Turbo", "power", "Off")
                    .transition("Turbo", "turbo", "Cool")
                    .transition("Turbo", "tooCold", "Cool")
                    .spontaneous("tooCold");
        }

        @Override
        StateMachineBuilder evolved() {
            return device("new")
                    .transition("Off", "extra", "Boost")
                    .transition("Dry", "extra", "Boost")
                    .transition("Boost", "power", "Off")
                    .transition("Boost", "extra", "Dry");
        }
    };

    private final String state;
    private final String deviceState;
    private final Set<String> sendable;

    Appliance(String state, String deviceState, String... sendable) {
        this.state = state;
        this.deviceState = deviceState;
        this.sendable = Set.of(sendable);
    }

    abstract StateMachineBuilder device(String name);

    abstract StateMachineBuilder evolved();

    /** The new state, whose function does nothing. */
    String newState() {
        return state;
    }

    Set<String> sendable() {
        return sendable;
    }

    ModelPair models() {
        return new ModelPair(
                device("original").build(),
                evolved().deviceState(state, deviceState).build());
    }

    StateKnowledge knowledge() {
        return new StateKnowledge(models()) {
            @Override
            protected void registerNewFunctions() {
                function(newState(), NewFunction.none());
            }
        };
    }
}
