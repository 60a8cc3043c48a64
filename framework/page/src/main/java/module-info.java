/** A running converter in the browser. */
@SuppressWarnings("module") // which modules there are is not known here
module org.evoloop.page {
    requires static org.jspecify;
    requires jdk.httpserver;
    requires transitive org.evoloop.config;
    requires transitive org.evoloop.console;
    requires org.slf4j;

    exports org.evoloop.page;
    exports org.evoloop.page.server to
            org.evoloop.studio;

    uses org.evoloop.page.Document;
}
