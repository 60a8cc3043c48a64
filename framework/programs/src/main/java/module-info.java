/** Shared by Evoloop's own programs: error messages, options and SVG. */
module org.evoloop.program {
    requires static org.jspecify;
    requires transitive info.picocli;
    requires transitive org.evoloop.config;

    exports org.evoloop.program;
}
