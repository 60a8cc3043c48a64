package org.evoloop.check.properties;

import java.util.List;
import org.evoloop.check.RuleSwitches;
import org.evoloop.check.temporal.Property;
import org.evoloop.check.timing.TimeRules;
import org.evoloop.evolution.ModelPair;

/**
 * What the author of an evolution has written beside its models: properties, what concerns time, and rules that are
 * switched off. docs/models.md and docs/time.md describe the language.
 *
 * <p>Threading: immutable.
 *
 * @param file what messages call it
 * @param properties in the order in which they are written
 * @since 0.1
 */
public record PropertyFile(String file, List<Property> properties, TimeRules time, RuleSwitches switches) {
    /** How the names of such files end. */
    public static final String ENDING = ".properties.txt";

    public PropertyFile {
        properties = List.copyOf(properties);
    }

    /** One in which nothing is written. */
    public static PropertyFile none() {
        return new PropertyFile("", List.of(), TimeRules.NONE, RuleSwitches.none());
    }

    /**
     * Reads a file's text.
     *
     * @param file for messages
     * @param pair whose states and events it names
     * @throws org.evoloop.statemachine.ModelException naming file, line and remedy of everything that cannot be
     *     understood
     */
    public static PropertyFile parse(String file, String text, ModelPair pair) {
        RuleSwitches switches = RuleSwitches.parse(file, text, pair);
        PropertyText read = PropertyText.parse(file, switches.rest(), pair);
        return new PropertyFile(file, read.properties(), read.time(), switches);
    }
}
