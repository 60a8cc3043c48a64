package org.evoloop.journal;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** Which start of the computer this is: what a killed process wrote is whole until the next. */
final class Boot {
    /** Empty where the system does not tell. */
    static final String ID = read();

    private Boot() {}

    private static String read() {
        try {
            return Files.readString(Path.of("/proc/sys/kernel/random/boot_id")).strip();
        } catch (IOException notLinux) {
            return "";
        }
    }
}
