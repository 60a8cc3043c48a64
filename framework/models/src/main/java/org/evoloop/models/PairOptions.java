package org.evoloop.models;

import org.evoloop.evolution.DeviceEvents;
import org.evoloop.evolution.ModelPair;
import org.evoloop.models.checking.Drawings;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.xmi.ModelReference;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;

/** The two models of an evolution, and what their author knows of the device. */
@SuppressWarnings("NullAway.Init") // picocli sets the fields
final class PairOptions {
    @Spec(Spec.Target.MIXEE)
    private CommandSpec spec;

    @Mixin
    private PairParameters models;

    @Mixin
    private DeviceOptions device;

    ModelReference original() {
        return models.original();
    }

    ModelReference evolved() {
        return models.evolved();
    }

    /** Reads both models. */
    ModelPair read() {
        return models.read(spec);
    }

    /** Where the parts of {@code pair} stand in their files. */
    Drawings drawings(ModelPair pair) {
        return new Drawings(
                ModelReader.drawing(original(), pair.original()), ModelReader.drawing(evolved(), pair.evolved()));
    }

    /** What passes between converter and device. @throws IllegalArgumentException for a name that the model lacks */
    DeviceEvents device(StateMachine original) {
        return device.of(original);
    }
}
