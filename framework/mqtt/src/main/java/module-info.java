/** A converter at an MQTT broker, and in Home Assistant. */
@SuppressWarnings("requires-automatic")
module org.evoloop.mqtt {
    requires static org.jspecify;
    requires transitive org.evoloop.config;
    requires transitive org.evoloop.console;
    requires transitive org.evoloop.payload;
    requires com.hivemq.client.mqtt;
    requires org.slf4j;

    exports org.evoloop.mqtt;
    exports org.evoloop.mqtt.edge;
    exports org.evoloop.mqtt.home;
}
