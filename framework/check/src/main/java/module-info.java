/** What is wrong with a pair of models, or likely to surprise. */
module org.evoloop.check {
    requires static org.jspecify;
    requires transitive org.evoloop.core;

    exports org.evoloop.check;
    exports org.evoloop.check.properties;
    exports org.evoloop.check.temporal;
    exports org.evoloop.check.timing;
}
