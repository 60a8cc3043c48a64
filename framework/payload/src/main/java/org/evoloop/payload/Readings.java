package org.evoloop.payload;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.evoloop.function.Reading;

/**
 * The readings in a device's messages.
 *
 * <p>Threading: thread-safe.
 *
 * @since 0.1
 */
public final class Readings {
    private final List<Rule> rules = new ArrayList<>();
    private final Map<String, Reading> known = new TreeMap<>();

    private record Rule(String source, String name, Part part, String unit) {}

    /** No reading is known. */
    public Readings() {}

    /**
     * Adds a reading.
     *
     * @param source where it is reported, such as a topic; empty if there is only one place
     * @param name as of a {@link Reading}, such as {@code battery}
     * @param unit of a number, such as {@code %}; else empty
     */
    public synchronized void add(String source, String name, Part part, String unit) {
        rules.add(new Rule(source, name, part, unit));
    }

    /** Takes what a message says. */
    public synchronized void hear(String source, String message) {
        for (Rule rule : rules) {
            if (rule.source().equals(source)) {
                rule.part().in(message).ifPresent(text -> known.put(rule.name(), reading(rule, text)));
            }
        }
    }

    private static Reading reading(Rule rule, String text) {
        if (text.equals("true") || text.equals("false")) {
            return Reading.of(rule.name(), Boolean.parseBoolean(text));
        }
        return Texts.value(text) instanceof Double number
                ? Reading.of(rule.name(), number, rule.unit())
                : Reading.of(rule.name(), text);
    }

    /** Forgets everything: the device cannot be reached. */
    public synchronized void clear() {
        known.clear();
    }

    /** What is known, by name. */
    public synchronized List<Reading> known() {
        return List.copyOf(known.values());
    }
}
