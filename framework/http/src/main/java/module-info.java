/** A controller that sends HTTP requests, and a device that accepts them. */
module org.evoloop.http {
    requires static org.jspecify;
    requires transitive org.evoloop.core;
    requires transitive org.evoloop.payload;
    requires jdk.httpserver;
    requires org.slf4j;

    exports org.evoloop.http;
}
