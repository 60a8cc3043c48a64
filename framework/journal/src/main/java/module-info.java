/** Records a converter's inputs in a file, so that a crash loses nothing. */
module org.evoloop.journal {
    requires static org.jspecify;
    requires transitive org.evoloop.check;
    requires transitive org.evoloop.core;
    requires org.slf4j;

    exports org.evoloop.journal;
}
