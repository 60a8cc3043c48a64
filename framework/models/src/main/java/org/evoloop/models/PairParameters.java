package org.evoloop.models;

import org.evoloop.evolution.ModelPair;
import org.evoloop.xmi.ModelReference;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Parameters;

/** The two models of an evolution. */
@SuppressWarnings("NullAway.Init") // picocli sets the fields
final class PairParameters {
    @Mixin
    private ReadingOptions reading;

    @Parameters(index = "0", paramLabel = "ORIGINAL", description = "The model of the device: FILE#NAME.")
    private String original;

    @Parameters(index = "1", paramLabel = "NEW", description = "What its owner wants: FILE#NAME.")
    private String evolved;

    ModelReference original() {
        return reading.reference(original);
    }

    ModelReference evolved() {
        return reading.reference(evolved);
    }

    /**
     * Reads both models.
     *
     * @param command prints what the files leave open
     */
    ModelPair read(CommandSpec command) {
        return ModelReader.pair(original(), evolved(), command);
    }
}
