/** What Evoloop's own programs have in common: how they tell a mistake, and how they draw. */
module org.evoloop.program {
    requires static org.jspecify;
    requires transitive info.picocli;
    requires transitive org.evoloop.config;

    exports org.evoloop.program;
}
