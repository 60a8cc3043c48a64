/** Metrics of a running converter, for Micrometer. */
@SuppressWarnings("requires-automatic")
module org.evoloop.metrics {
    requires static org.jspecify;
    requires micrometer.core;
    requires transitive org.evoloop.core;

    exports org.evoloop.metrics;
}
