package org.evoloop.xmi.dialect;

import java.util.Optional;
import org.evoloop.statechart.Statechart;

/**
 * One state machine in a file of any dialect.
 *
 * <p>Threading: immutable once the file has been read.
 */
public interface DrawnMachine {

    /** Unique in a file written by a tool; empty if the file gives none. */
    String id();

    /** The machine's own name, often a default of the tool; may be empty. */
    String name();

    /** The name of the diagram that shows the machine; empty if there is none, or if the dialect stores no diagrams. */
    default Optional<String> diagramName() {
        return Optional.empty();
    }

    /** The machine's first line in the file, counted from 1. */
    int line();

    /**
     * The machine as drawn. Each element of it is either used, known to have no effect on behavior, or reported as a
     * problem.
     *
     * @param title the author's name for the machine; becomes the chart's name
     * @param problems receives everything that cannot be used; if it is not empty, the result is not used
     */
    Statechart statechart(String title, Problems problems);
}
