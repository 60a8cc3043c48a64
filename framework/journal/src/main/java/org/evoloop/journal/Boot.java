package org.evoloop.journal;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** Identifies the present boot of the computer: what a killed process wrote stays complete until the next boot. */
final class Boot {
    /** Empty if the system does not provide it. */
    static final String ID = read();

    private Boot() {}

    /** Whether the computer has been started since the boot with this identity; false if that is unknown. */
    static boolean hasEnded(String boot) {
        return !boot.isEmpty() && !boot.equals(ID);
    }

    private static String read() {
        try {
            return Files.readString(Path.of("/proc/sys/kernel/random/boot_id")).strip();
        } catch (IOException notLinux) {
            return "";
        }
    }
}
