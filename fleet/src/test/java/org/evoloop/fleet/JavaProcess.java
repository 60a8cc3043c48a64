package org.evoloop.fleet;

import java.io.File;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** Programs in processes of their own, which can be killed. */
public final class JavaProcess {
    private JavaProcess() {}

    /** Starts a program; what it prints is appended to a file in {@code directory}. */
    public static Process start(Path directory, Class<?> program, String... arguments) {
        List<String> command = new ArrayList<>(List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-XX:TieredStopAtLevel=1",
                "-XX:+UseSerialGC",
                "-cp",
                System.getProperty("java.class.path"),
                program.getName()));
        command.addAll(List.of(arguments));
        File log = directory.resolve(program.getSimpleName() + ".log").toFile();
        try {
            return new ProcessBuilder(command)
                    .redirectErrorStream(true)
                    .redirectOutput(ProcessBuilder.Redirect.appendTo(log))
                    .start();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Kills it, which it cannot notice, and waits until it has ended. */
    public static void kill(Process process) throws InterruptedException {
        process.destroyForcibly().waitFor();
    }
}
