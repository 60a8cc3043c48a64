package org.evoloop.models;

import java.util.Optional;
import org.evoloop.xmi.ModelReference;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Option;

/** How models are read where their files leave it open. */
final class ReadingOptions {
    @Option(
            names = "--time-unit",
            paramLabel = "ms|s",
            description =
                    "Unit of time triggers that are numbers without a unit, such as after(2); by default these are"
                            + " refused.")
    private @Nullable String timeUnit;

    /** What {@code FILE#NAME} names, to be read as the options say. */
    ModelReference reference(String text) {
        return ModelReference.parse(text)
                .withTimeUnit(Optional.ofNullable(timeUnit).map(ModelReference::unit));
    }
}
