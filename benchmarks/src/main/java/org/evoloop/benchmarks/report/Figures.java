package org.evoloop.benchmarks.report;

import java.util.HashMap;
import java.util.Map;

/**
 * The figures that a process has measured, by name.
 *
 * <p>Threading: immutable.
 */
public final class Figures {
    private final Map<String, Double> byName = new HashMap<>();

    /** Reads lines of a name, a space and a number; ignores other lines. */
    public static Figures parse(String text) {
        Figures figures = new Figures();
        for (String line : text.lines().toList()) {
            int space = line.lastIndexOf(' ');
            if (space > 0) {
                figures.byName.put(line.substring(0, space), Double.valueOf(line.substring(space + 1)));
            }
        }
        return figures;
    }

    /**
     * The figure with this name.
     *
     * @throws IllegalStateException if there is none
     */
    public double get(String name) {
        Double figure = byName.get(name);
        if (figure == null) {
            throw new IllegalStateException("the measurement did not report " + name);
        }
        return figure;
    }
}
