/** A converter that runs by itself: by name, under a service manager, controlled through a socket. */
module org.evoloop.service {
    requires static org.jspecify;
    requires transitive org.evoloop.config;
    requires transitive org.evoloop.console;
    requires org.slf4j;

    exports org.evoloop.service;
}
