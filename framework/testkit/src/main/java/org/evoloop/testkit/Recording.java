package org.evoloop.testkit;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.evoloop.check.properties.PropertyFile;
import org.evoloop.evolution.ModelPair;
import org.evoloop.journal.DryRun;
import org.evoloop.journal.DryRun.Broken;
import org.evoloop.journal.JournalFiles;
import org.evoloop.rehearsal.Difference;
import org.jspecify.annotations.Nullable;

/**
 * The recorded inputs of a converter: its journal, or a copy of the directory that is kept beside the tests. Replayed
 * with the present models, it is a regression test.
 *
 * <pre>{@code
 * Recording.in(Path.of("src/test/recordings/sunday"))
 *         .withProperties(Path.of("models/lamp.properties.txt"))
 *         .replay(models)
 *         .expectSameDecisions()
 *         .expectPropertiesKept();
 * }</pre>
 *
 * <p>The files are only read.
 *
 * <p>Threading: immutable.
 *
 * @since 0.1
 */
public final class Recording {
    private final Path directory;
    private final @Nullable Path properties;

    private Recording(Path directory, @Nullable Path properties) {
        this.directory = directory;
        this.properties = properties;
    }

    /** The recording in {@code directory}, the journal directory of a converter. */
    public static Recording in(Path directory) {
        return new Recording(directory, null);
    }

    /** A copy with properties that the models must satisfy, in the language of {@code models check}. */
    public Recording withProperties(Path file) {
        return new Recording(directory, file);
    }

    /**
     * Replays the converter's inputs with other models, or with the same.
     *
     * @throws org.evoloop.journal.JournalException if there is no journal, or it is damaged
     * @throws org.evoloop.statemachine.ModelException if the models are not an evolution, or the properties cannot be
     *     understood
     * @throws IllegalArgumentException if the properties cannot be read
     */
    public Replay replay(ModelPair models) {
        Path file = properties;
        PropertyFile written =
                file == null ? PropertyFile.none() : PropertyFile.parse(file.toString(), text(file), models);
        return new Replay(DryRun.of(new JournalFiles(directory), models, written.properties()), written);
    }

    private static String text(Path file) {
        try {
            return Files.readString(file);
        } catch (IOException unreadable) {
            throw new IllegalArgumentException(
                    file + " cannot be read as text (" + unreadable + "); name a file of properties", unreadable);
        }
    }

    /**
     * The results of a replay.
     *
     * <p>Errors: a failed expectation is an {@link AssertionError} that lists the events.
     *
     * <p>Threading: immutable.
     */
    public static final class Replay {
        private final DryRun.Result result;
        private final PropertyFile written;

        private Replay(DryRun.Result result, PropertyFile written) {
            this.result = result;
            this.written = written;
        }

        /** The number of events. */
        public long events() {
            return result.events();
        }

        /** The events that these models decide differently, in order. */
        public List<Difference> differences() {
            return result.differences();
        }

        /** The violated properties, each with the event that violates it, in order. */
        public List<Broken> broken() {
            return result.broken();
        }

        /** Requires that every event is decided as recorded. */
        public Replay expectSameDecisions() {
            return require(
                    differences(),
                    differences().size() + " of " + events() + " events are decided differently from the recording:");
        }

        /** Requires that no property is violated. */
        public Replay expectPropertiesKept() {
            return require(
                    broken(),
                    broken().size() + " of " + written.properties().size() + " properties in " + written.file()
                            + " are broken:");
        }

        private Replay require(List<?> none, String message) {
            if (!none.isEmpty()) {
                StringBuilder text = new StringBuilder(message);
                none.forEach(each -> text.append("\n  ").append(each));
                throw new AssertionError(text);
            }
            return this;
        }
    }
}
