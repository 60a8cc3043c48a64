package org.evoloop.xmi.dialect;

import java.util.Optional;
import org.evoloop.statechart.Statechart;

/**
 * One state machine in a file of some dialect.
 *
 * <p>Threading: immutable once the file has been read.
 */
public interface DrawnMachine {

    /** Unique in a file that its tool wrote; empty if the file gives none. */
    String id();

    /** The machine's own name, often the tool's default; may be empty. */
    String name();

    /** The name of the diagram that shows the machine; empty if there is none, or if the dialect keeps no diagrams. */
    default Optional<String> diagramName() {
        return Optional.empty();
    }

    /** Where the machine starts in the file, counted from 1. */
    int line();

    /**
     * The machine as drawn, with all that is in it: each element is used, known to say nothing about behavior, or a
     * problem.
     *
     * @param title what its author calls the machine; the chart's name
     * @param problems takes everything that cannot be used; unless it stays empty nobody looks at the result
     */
    Statechart statechart(String title, Problems problems);
}
