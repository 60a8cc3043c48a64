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
                    "Unit of time triggers that have a number without one, such as after(2); unless given, those are"
                            + " refused.")
    private @Nullable String timeUnit;

    /** What {@code FILE#NAME} names, to be read as the options say. */
    ModelReference reference(String text) {
        return ModelReference.parse(text)
                .withTimeUnit(Optional.ofNullable(timeUnit).map(ModelReference::unit));
    }
}
