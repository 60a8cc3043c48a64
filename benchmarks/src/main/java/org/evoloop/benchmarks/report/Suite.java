package org.evoloop.benchmarks.report;

import java.util.List;

/** Measurements that belong together. */
public interface Suite {
    /** As on the command line. */
    String name();

    /**
     * Measures.
     *
     * @param quick whether rougher figures will do
     */
    List<Row> measure(boolean quick) throws Exception;
}
