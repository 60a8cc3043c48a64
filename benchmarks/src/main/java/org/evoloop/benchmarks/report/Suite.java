package org.evoloop.benchmarks.report;

import java.util.List;

/** A group of related measurements. */
public interface Suite {
    /** The name on the command line. */
    String name();

    /**
     * Runs the measurements.
     *
     * @param quick whether rougher figures suffice
     */
    List<Row> measure(boolean quick) throws Exception;
}
