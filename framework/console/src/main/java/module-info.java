/** The console of a running converter. */
module org.evoloop.console {
    requires static org.jspecify;
    requires static jdk.unsupported;
    // Line editing, if it is available.
    requires static org.jline.reader;
    requires static org.jline.terminal;
    requires transitive org.evoloop.core;
    requires transitive org.evoloop.payload;
    requires org.slf4j;

    exports org.evoloop.console;
}
