/** An unattended converter: it has a name, runs under a service manager, and is controlled through a socket. */
module org.evoloop.service {
    requires static org.jspecify;
    // Receives the log, if it is present.
    requires static ch.qos.logback.classic;
    requires static ch.qos.logback.core;
    requires transitive org.evoloop.config;
    requires transitive org.evoloop.console;
    requires org.slf4j;

    exports org.evoloop.service;

    provides ch.qos.logback.classic.spi.Configurator with
            org.evoloop.service.ProgramLog;
}
