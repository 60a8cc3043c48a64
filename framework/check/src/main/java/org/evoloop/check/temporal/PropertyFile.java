package org.evoloop.check.temporal;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.evoloop.check.RuleSwitches;
import org.evoloop.evolution.ModelPair;

/**
 * What the author of an evolution has written beside its models: properties, and rules that are switched off. docs/models.md
 * describes the language.
 *
 * <p>Threading: immutable.
 *
 * @param file what messages call it
 * @param properties in the order in which they are written
 * @since 0.1
 */
public record PropertyFile(String file, List<Property> properties, RuleSwitches switches) {
    /** How the names of such files end. */
    public static final String ENDING = ".properties.txt";

    public PropertyFile {
        properties = List.copyOf(properties);
    }

    /** One in which nothing is written. */
    public static PropertyFile none() {
        return new PropertyFile("", List.of(), RuleSwitches.none());
    }

    /**
     * Reads a file's text.
     *
     * @param file for messages
     * @param pair whose states and events it names
     * @throws org.evoloop.statemachine.ModelException naming file, line and remedy of everything that cannot be understood
     */
    public static PropertyFile parse(String file, String text, ModelPair pair) {
        RuleSwitches switches = RuleSwitches.parse(file, text, pair);
        return new PropertyFile(file, PropertyText.parse(file, switches.rest(), pair), switches);
    }

    /**
     * The file beside {@code models} that is called like it and the machine, if there is one, else like it alone: {@code
     * a.b.properties.txt} or {@code a.properties.txt} for {@code a.xml} and the machine b. It need not be there.
     */
    public static Path beside(Path models, Optional<String> machine) {
        return machine.map(name -> named(models, "." + name))
                .filter(Files::exists)
                .orElseGet(() -> named(models, ""));
    }

    private static Path named(Path models, String machine) {
        String name = String.valueOf(models.getFileName());
        int dot = name.lastIndexOf('.');
        return models.resolveSibling((dot > 0 ? name.substring(0, dot) : name) + machine + ENDING);
    }
}
