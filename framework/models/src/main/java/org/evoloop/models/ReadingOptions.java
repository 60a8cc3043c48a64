package org.evoloop.models;

import java.util.Optional;
import org.evoloop.xmi.ModelReference;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Option;

/** Options for reading models whose files are ambiguous. */
final class ReadingOptions {
    @Option(
            names = "--time-unit",
            paramLabel = "ms|s",
            description =
                    "Unit of time triggers that are numbers without a unit, such as after(2); by default these are"
                            + " refused.")
    private @Nullable String timeUnit;

    /** Parses {@code FILE#NAME}; the model will be read as the options say. */
    ModelReference reference(String text) {
        return ModelReference.parse(text)
                .withTimeUnit(Optional.ofNullable(timeUnit).map(ModelReference::unit));
    }
}
