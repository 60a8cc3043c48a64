/** A connected Roomba: its connection, what its frames tell, and control of it. */
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
