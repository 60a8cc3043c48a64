package org.evoloop.check.temporal;

import java.util.ArrayList;
import java.util.List;
import org.evoloop.evolution.ModelPair;
import org.evoloop.statemachine.ModelException;

/** Reads the text of a file of properties: a property a line, {@code name: formula}; more of it on indented lines. */
final class PropertyText {
    private final FormulaParser parser;
    private final String file;
    private final List<Property> properties = new ArrayList<>();
    private final List<String> problems = new ArrayList<>();
    private final StringBuilder pending = new StringBuilder();
    private int pendingLine;

    private PropertyText(String file, ModelPair pair) {
        this.file = file;
        this.parser = new FormulaParser(pair);
    }

    /**
     * The properties, in order.
     *
     * @param file for messages
     * @throws ModelException naming file, line and mend of everything that cannot be understood
     */
    static List<Property> parse(String file, String text, ModelPair pair) {
        PropertyText reader = new PropertyText(file, pair);
        List<String> lines = text.lines().toList();
        for (int index = 0; index < lines.size(); index++) {
            reader.line(lines.get(index), index + 1);
        }
        reader.flush();
        if (!reader.problems.isEmpty()) {
            throw new ModelException(String.join("\n", reader.problems));
        }
        return List.copyOf(reader.properties);
    }

    private void line(String line, int number) {
        String content = line.strip();
        if (content.isEmpty() || content.startsWith("#")) {
            return;
        }
        if (!Character.isWhitespace(line.charAt(0))) {
            flush();
            pendingLine = number;
        }
        pending.append(content).append(' ');
    }

    private void flush() {
        String text = pending.toString().strip();
        pending.setLength(0);
        if (text.isEmpty()) {
            return;
        }
        int colon = text.indexOf(':');
        String name = colon < 0 ? text : text.substring(0, colon).strip();
        try {
            properties.add(new Property(name, parser.parse(text.substring(colon + 1)), pendingLine));
        } catch (ModelException problem) {
            problems.add(file + ", line " + pendingLine + ": " + problem.getMessage());
        }
    }
}
