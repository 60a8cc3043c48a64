/** What the messages of a controller or a device mean. */
module org.evoloop.payload {
    requires static org.jspecify;
    requires transitive org.evoloop.core;
    requires org.slf4j;
    requires tools.jackson.core;

    exports org.evoloop.payload;
    exports org.evoloop.payload.report;
}
