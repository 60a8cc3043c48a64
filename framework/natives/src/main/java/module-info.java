/** Loads the native parts of JNA and jSerialComm from where nobody else can put a file, and makes pseudo-terminals with them. */
module org.evoloop.natives {
    requires static org.jspecify;
    requires com.sun.jna;
    // Whoever has it loaded brings it.
    requires static com.fazecast.jSerialComm;

    exports org.evoloop.natives;
}
