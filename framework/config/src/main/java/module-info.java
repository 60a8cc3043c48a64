/** A program's options: from its command line, a YAML file and the environment, checked as a whole. */
module org.evoloop.config {
    requires static org.jspecify;
    requires transitive info.picocli;
    requires org.evoloop.core;
    requires org.snakeyaml.engine;

    exports org.evoloop.config;
}
