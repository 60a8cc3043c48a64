/** Loads the native parts of JNA and jSerialComm from where nobody else can put a file. */
module org.evoloop.roomba.natives {
    requires static org.jspecify;
    requires com.sun.jna;
    // Whoever has it loaded brings it.
    requires static com.fazecast.jSerialComm;

    exports org.evoloop.roomba.natives;
}
