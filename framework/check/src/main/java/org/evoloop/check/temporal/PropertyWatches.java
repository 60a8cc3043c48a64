package org.evoloop.check.temporal;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import org.evoloop.converter.HistoryEntry;
import org.evoloop.converter.Probation;
import org.evoloop.evolution.ModelPair;
import org.evoloop.statemachine.ModelException;

/**
 * Watches properties while other models are on probation.
 *
 * @since 0.1
 */
public final class PropertyWatches {
    private PropertyWatches() {}

    /** A property that is broken brings the models before back. */
    public static Probation.Watches of(List<Property> properties) {
        return (table, from) -> {
            PropertyWatch watch = new PropertyWatch(properties, table, from);
            return entry -> brokenBy(entry, watch);
        };
    }

    private static String brokenBy(HistoryEntry entry, PropertyWatch watch) {
        List<Property> broken = watch.ended(entry.occurrence(), entry.after(), entry.outcome(), entry.decision());
        return broken.isEmpty()
                ? ""
                : entry.occurrence().label() + " breaks "
                        + broken.stream().map(Property::name).collect(Collectors.joining(", "));
    }

    /**
     * The same with the properties beside a file of models; none if there is no such file.
     *
     * @param models the file, see {@link PropertyFile#beside}
     * @param machine the new model in it, by name; empty for its only one
     * @param pair both models
     * @throws ModelException if the properties cannot be read or understood
     */
    public static Probation.Watches beside(Path models, Optional<String> machine, ModelPair pair) {
        Path file = PropertyFile.beside(models, machine);
        if (!Files.exists(file)) {
            return of(List.of());
        }
        try {
            return of(PropertyFile.parse(file.toString(), Files.readString(file), pair)
                    .properties());
        } catch (IOException e) {
            throw new ModelException(file + " cannot be read: " + e.getMessage(), e);
        }
    }
}
