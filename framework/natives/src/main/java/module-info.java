/**
 * Loads the native parts of JNA and jSerialComm from a place where no other user can put a file, and creates
 * pseudo-terminals.
 */
module org.evoloop.natives {
    requires static org.jspecify;
    requires com.sun.jna;
    // Provided by the module that loads jSerialComm.
    requires static com.fazecast.jSerialComm;

    exports org.evoloop.natives;
}
