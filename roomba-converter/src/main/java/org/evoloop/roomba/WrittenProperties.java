package org.evoloop.roomba;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import org.evoloop.check.properties.PropertyFile;
import org.evoloop.check.timing.TimeRules;
import org.evoloop.check.timing.TimeWatch;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Sentry;
import org.evoloop.statemachine.ModelException;
import org.evoloop.xmi.ModelReference;
import org.jspecify.annotations.Nullable;

/**
 * The property files next to the files of new models.
 *
 * <p>Threading: thread-safe.
 */
final class WrittenProperties implements Sentry.Posting {
    private final Map<String, TimeRules> time = new ConcurrentHashMap<>();

    /**
     * Reads the properties of the new model; none if there is no such file.
     *
     * @throws ModelException if it cannot be read or understood
     */
    PropertyFile read(ModelPair models) {
        String reference = models.evolved().name();
        Path file = ModelReference.parse(reference).beside(PropertyFile.ENDING);
        PropertyFile written = PropertyFile.none();
        if (Files.exists(file)) {
            try {
                written = PropertyFile.parse(file.toString(), Files.readString(file), models);
            } catch (IOException e) {
                throw new ModelException(file + " cannot be read: " + e.getMessage(), e);
            }
        }
        time.put(reference, written.time());
        return written;
    }

    /** Watches the properties that were read before. */
    @Override
    public @Nullable Sentry post(ModelPair models, Configuration at, long atNanos) {
        TimeRules rules = time.getOrDefault(models.evolved().name(), TimeRules.NONE);
        return rules.properties().isEmpty() ? null : new TimeWatch(rules, models, at, atNanos);
    }
}
