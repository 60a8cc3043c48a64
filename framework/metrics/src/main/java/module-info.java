/** Metrics of a running converter for Prometheus. */
@SuppressWarnings("requires-automatic")
module org.evoloop.metrics {
    requires static org.jspecify;
    requires transitive org.evoloop.page;
    requires micrometer.core;
    requires micrometer.registry.prometheus;

    exports org.evoloop.metrics;

    provides org.evoloop.page.Document with
            org.evoloop.metrics.PrometheusDocument;
}
