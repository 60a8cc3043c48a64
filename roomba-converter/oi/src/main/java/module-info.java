/** The Roomba Open Interface: commands, packets and streams as bytes and as values, without any I/O. */
module org.evoloop.roomba.oi {
    requires static org.jspecify;

    exports org.evoloop.roomba.oi;
}
