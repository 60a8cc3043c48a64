/** A running converter in the browser. */
module org.evoloop.page {
    requires static org.jspecify;
    requires jdk.httpserver;
    requires transitive org.evoloop.config;
    requires transitive org.evoloop.console;
    requires org.slf4j;

    exports org.evoloop.page;

    uses org.evoloop.page.Document;
}
