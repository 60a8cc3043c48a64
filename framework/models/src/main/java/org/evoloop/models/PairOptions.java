package org.evoloop.models;

import java.util.Map;
import org.evoloop.evolution.DeviceEvents;
import org.evoloop.evolution.ModelPair;
import org.evoloop.models.checking.Drawings;
import org.evoloop.xmi.ModelReference;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** The two models of an evolution, and what their author knows about the device. */
@SuppressWarnings("NullAway.Init") // picocli sets the fields
final class PairOptions {
    @Spec(Spec.Target.MIXEE)
    private CommandSpec spec;

    @Mixin
    private PairParameters models;

    @Mixin
    private DeviceOptions device;

    @Option(
            names = "--on-failure",
            paramLabel = "EVENT[@STATE]=CHOICE",
            description =
                    "What to do when a step of a path for EVENT fails, in STATE of the new model or in all states: back"
                            + " (send the device back to where the path began), other-way (continue by another path) or"
                            + " stay (the default).")
    private Map<String, String> onFailure = Map.of();

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

    /** Locates the elements of {@code pair} in their files. */
    Drawings drawings(ModelPair pair) {
        return new Drawings(
                ModelReader.drawing(original(), pair.original()), ModelReader.drawing(evolved(), pair.evolved()));
    }

    /**
     * The events between converter and device.
     *
     * @throws IllegalArgumentException for a name that the models lack
     */
    DeviceEvents device(ModelPair pair) {
        return device.of(pair.original()).withOnFailure(FailureChoices.of(onFailure, pair.evolved()));
    }
}
