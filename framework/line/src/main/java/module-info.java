/** A controller or a device that exchanges lines of text. */
module org.evoloop.line {
    requires static org.jspecify;
    requires transitive org.evoloop.core;
    requires transitive org.evoloop.payload;
    requires org.slf4j;

    exports org.evoloop.line;
}
