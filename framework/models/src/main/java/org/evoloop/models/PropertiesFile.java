package org.evoloop.models;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.evoloop.check.properties.PropertyFile;
import org.evoloop.evolution.ModelPair;
import org.evoloop.xmi.ModelReference;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Option;

/** The file with the properties that an evolution must keep. */
@SuppressWarnings("NullAway.Init") // picocli sets the field
final class PropertiesFile {
    @Option(
            names = "--properties",
            paramLabel = "FILE",
            description = "Properties of the new model (default: for a.xml#b, the file a.b" + PropertyFile.ENDING
                    + " or else a" + PropertyFile.ENDING + " beside it, if there is one).")
    private @Nullable Path given;

    /** The file given, or else the default one beside {@code evolved}, which may not exist. */
    Path path(ModelReference evolved) {
        return given != null ? given : evolved.beside(PropertyFile.ENDING);
    }

    /** Whether there is a file; one that was given must exist. */
    boolean isThere(ModelReference evolved) {
        return given != null || Files.exists(path(evolved));
    }

    /**
     * The properties of {@code pair}; none if there is no file.
     *
     * @throws IOException if the file cannot be read
     * @throws org.evoloop.statemachine.ModelException if it cannot be parsed
     */
    PropertyFile read(ModelReference evolved, ModelPair pair) throws IOException {
        return isThere(evolved) ? parse(text(evolved), evolved, pair) : PropertyFile.none();
    }

    /** As {@link #read}, of a file that is there; returns its text. */
    String text(ModelReference evolved, ModelPair pair) throws IOException {
        String text = text(evolved);
        parse(text, evolved, pair);
        return text;
    }

    private String text(ModelReference evolved) throws IOException {
        return TextFile.read(path(evolved), "properties");
    }

    private PropertyFile parse(String text, ModelReference evolved, ModelPair pair) {
        return PropertyFile.parse(path(evolved).toString(), text, pair);
    }
}
