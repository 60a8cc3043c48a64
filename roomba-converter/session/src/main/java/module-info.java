/** A connected Roomba: its connection, the interpretation of its frames, and its control. */
module org.evoloop.roomba.session {
    requires static org.jspecify;
    requires transitive org.evoloop.core;
    requires transitive org.evoloop.link;
    requires transitive org.evoloop.roomba.oi;
    requires org.slf4j;

    exports org.evoloop.roomba.session;
    exports org.evoloop.roomba.session.connection;
    exports org.evoloop.roomba.session.inference;
}
