package org.evoloop.check.properties;

import java.util.List;
import org.evoloop.check.RuleSwitches;
import org.evoloop.check.temporal.Property;
import org.evoloop.check.timing.TimeRules;
import org.evoloop.evolution.ModelPair;

/**
 * The property file beside an evolution's models: properties, lines about time, and rules that are switched off.
 * docs/models.md and docs/time.md describe the language.
 *
 * <p>Threading: immutable.
 *
 * @param file its name in messages
 * @param properties the properties, in the file's order
 * @since 0.1
 */
public record PropertyFile(String file, List<Property> properties, TimeRules time, RuleSwitches switches) {
    /** The ending of such files' names. */
    public static final String ENDING = ".properties.txt";

    public PropertyFile {
        properties = List.copyOf(properties);
    }

    /** An empty file. */
    public static PropertyFile none() {
        return new PropertyFile("", List.of(), TimeRules.NONE, RuleSwitches.none());
    }

    /**
     * Parses a file's text.
     *
     * @param file for messages
     * @param pair the models whose states and events it names
     * @throws org.evoloop.statemachine.ModelException naming file, line and remedy of everything that cannot be
     *     understood
     */
    public static PropertyFile parse(String file, String text, ModelPair pair) {
        RuleSwitches switches = RuleSwitches.parse(file, text, pair);
        PropertyText read = PropertyText.parse(file, switches.rest(), pair);
        return new PropertyFile(file, read.properties(), read.time(), switches);
    }
}
