/** A controller or a device in Home Assistant. */
module org.evoloop.homeassistant {
    requires static org.jspecify;
    requires transitive org.evoloop.core;
    requires transitive org.evoloop.payload;
    requires org.evoloop.config;
    requires java.net.http;
    requires org.slf4j;

    exports org.evoloop.homeassistant;
}
