/** For tests of converters: a harness without threads, and simulated devices made from models. */
module org.evoloop.testkit {
    requires static org.jspecify;
    requires transitive org.evoloop.core;
    requires transitive org.evoloop.journal;
    requires ch.qos.logback.classic;
    requires ch.qos.logback.core;
    requires org.slf4j;

    exports org.evoloop.testkit;
}
