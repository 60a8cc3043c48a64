package org.evoloop.journal;

import java.util.Set;
import org.evoloop.converter.StateKnowledge;
import org.evoloop.evolution.ModelPair;
import org.evoloop.function.NewFunction;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.StateMachineBuilder;

/**
 * Devices that people retrofit, whose new models have states that need the device somewhere, and a press that takes
 * several steps to a state that the device has itself. Most events toggle something.
 */
enum Appliance {
    /** Stopped half-way for air; one button does everything. */
    SHUTTER("tap") {
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
                    .transition("HalfUp", "extra", "ToAir")
                    .transition("Airing", "tap", "Falling")
                    .transition("Airing", "extra", "Rising")
                    .transition("ToAir", "extra", "Airing")
                    .transition("ToAir", "top", "Up")
                    .deviceState("Airing", "HalfUp")
                    .deviceState("ToAir", "Rising");
        }
    },
    /** Heated for somebody who waits. */
    KETTLE("power") {
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
                    .transition("Ready", "again", "Heating")
                    .transition("Tea", "hot", "Ready")
                    .transition("Tea", "power", "Off")
                    .deviceState("Tea", "Heating");
        }
    },
    /** Turbo, and then the mode before. */
    AIR_CONDITIONER("power", "mode", "turbo") {
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
                    .transition("Off", "again", "Dry")
                    .transition("Dry", "extra", "Boost")
                    .transition("Boost", "power", "Off")
                    .transition("Boost", "extra", "Dry")
                    .deviceState("Boost", "Turbo");
        }
    };

    private final Set<String> sendable;

    Appliance(String... sendable) {
        this.sendable = Set.of(sendable);
    }

    abstract StateMachineBuilder device(String name);

    abstract StateMachineBuilder evolved();

    Set<String> sendable() {
        return sendable;
    }

    ModelPair models() {
        return new ModelPair(device("original").build(), evolved().build());
    }

    /** Functions that do nothing. */
    StateKnowledge knowledge() {
        return new StateKnowledge(models()) {
            @Override
            protected void registerNewFunctions() {
                for (State state : models().evolved().states()) {
                    if (models().isNew(state)) {
                        function(state.name(), NewFunction.none());
                    }
                }
            }
        };
    }
}
