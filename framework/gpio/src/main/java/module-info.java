/** Buttons and relays on the pins of a Raspberry Pi. */
module org.evoloop.gpio {
    requires static org.jspecify;
    requires transitive org.evoloop.config;
    requires transitive org.evoloop.core;
    requires transitive com.pi4j;
    requires com.pi4j.plugin.gpiod;
    requires org.slf4j;

    exports org.evoloop.gpio;
}
