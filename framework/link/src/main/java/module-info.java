/** The bytes to and from a device: over a serial port or in memory, with diagnosed faults. */
module org.evoloop.link {
    requires static org.jspecify;
    requires org.evoloop.natives;
    requires com.fazecast.jSerialComm;
    requires com.sun.jna;
    requires org.slf4j;

    exports org.evoloop.link;
}
