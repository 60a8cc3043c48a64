package org.evoloop.console;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * Distinguishes standard input from a file of the JVM's own. If a program is started with file descriptor 0 closed, the
 * first file that it opens gets that number, and its contents would be taken for commands.
 */
final class StandardInput {
    private static final Path FILE = Path.of("/proc/self/fd/0");
    private static final Path INFO = Path.of("/proc/self/fdinfo/0");

    /** The flag of Linux; inherited files do not have it. */
    private static final long CLOSE_ON_EXEC = 0x80000;

    private static final String FLAGS = "flags:";

    private StandardInput() {}

    /** Whether this process was started with a standard input; true if that cannot be determined. */
    static boolean isThere() {
        if (!Files.isDirectory(Path.of("/proc/self/fdinfo"))) {
            return true;
        }
        try {
            return !isOfTheVirtualMachine() && !isClosedOnExec();
        } catch (IOException none) {
            return false;
        }
    }

    private static boolean isOfTheVirtualMachine() throws IOException {
        Path home = Path.of(System.getProperty("java.home")).toRealPath();
        return Files.readSymbolicLink(FILE).startsWith(home);
    }

    private static boolean isClosedOnExec() throws IOException {
        return Files.readAllLines(INFO).stream()
                .filter(line -> line.startsWith(FLAGS))
                .map(line -> line.substring(FLAGS.length()).strip())
                .anyMatch(flags -> (Long.parseLong(flags, 8) & CLOSE_ON_EXEC) != 0);
    }
}
