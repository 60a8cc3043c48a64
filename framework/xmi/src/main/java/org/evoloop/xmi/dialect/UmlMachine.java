package org.evoloop.xmi.dialect;

import java.util.function.BiFunction;
import org.evoloop.statechart.Statechart;

/**
 * A state machine of a UML file, uninterpreted.
 *
 * @param reading builds the chart with the given title, see {@link #statechart}
 */
public record UmlMachine(UmlElement element, BiFunction<String, Problems, Statechart> reading) implements DrawnMachine {

    @Override
    public String id() {
        return element.id();
    }

    @Override
    public String name() {
        return element.name();
    }

    @Override
    public int line() {
        return element.line();
    }

    @Override
    public Statechart statechart(String title, Problems problems) {
        return reading.apply(title, problems);
    }
}
