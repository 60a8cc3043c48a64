/** The bytes to and from a Roomba: over a serial port or in memory, with diagnosed faults. */
module org.evoloop.roomba.link {
    requires static org.jspecify;
    requires org.evoloop.roomba.natives;
    requires com.fazecast.jSerialComm;
    requires com.sun.jna;
    requires org.slf4j;

    exports org.evoloop.roomba.link;
}
