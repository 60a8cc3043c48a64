/** Models drawn, checked, tried and evolved in the browser. */
@SuppressWarnings("module") // which modules there are is not known here
module org.evoloop.studio {
    requires static org.jspecify;
    requires jdk.httpserver;
    requires org.evoloop.config;
    requires org.evoloop.core;
    requires org.evoloop.device;
    requires transitive org.evoloop.page;
    requires transitive org.evoloop.payload;
    requires org.evoloop.service;
    requires org.evoloop.testkit;
    requires transitive org.evoloop.xmi;

    exports org.evoloop.studio to
            org.evoloop.models;
}
