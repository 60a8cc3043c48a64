/** A serial port for a controller or a device that exchanges lines of text. */
module org.evoloop.serial {
    requires static org.jspecify;
    requires transitive org.evoloop.line;
    requires org.evoloop.link;

    exports org.evoloop.serial;
}
