/** Finds errors and likely surprises in a pair of models. */
module org.evoloop.check {
    requires static org.jspecify;
    requires transitive org.evoloop.core;

    exports org.evoloop.check;
    exports org.evoloop.check.properties;
    exports org.evoloop.check.temporal;
    exports org.evoloop.check.timing;
}
