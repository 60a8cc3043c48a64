/** A converter as a program: options, console, service, journal, page and MQTT behind one builder. */
@SuppressWarnings("requires-automatic")
module org.evoloop.program {
    requires static org.jspecify;
    requires transitive org.evoloop.config;
    requires transitive org.evoloop.console;
    requires transitive org.evoloop.core;
    requires transitive org.evoloop.journal;
    requires transitive org.evoloop.mqtt;
    requires transitive org.evoloop.page;
    requires transitive org.evoloop.service;
    requires transitive org.evoloop.xmi;
    requires micrometer.core;
    requires micrometer.registry.prometheus;
    requires org.evoloop.metrics;
    requires org.slf4j;

    exports org.evoloop.program;

    provides org.evoloop.page.Document with
            org.evoloop.program.prometheus.PrometheusDocument;
}
