/** A converter that runs by itself: by name, under a service manager, controlled through a socket. */
module org.evoloop.service {
    requires static org.jspecify;
    // Where the log goes, if it is there.
    requires static ch.qos.logback.classic;
    requires static ch.qos.logback.core;
    requires transitive org.evoloop.config;
    requires transitive org.evoloop.console;
    requires org.slf4j;

    exports org.evoloop.service;

    provides ch.qos.logback.classic.spi.Configurator with
            org.evoloop.service.ProgramLog;
}
