package org.evoloop.fleet;

import java.io.File;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import org.evoloop.JavaProcess;

/** Programs in processes of their own, which can be killed. */
public final class TestProcess {
    private TestProcess() {}

    /** Starts a program; its output is appended to a file in {@code directory}. */
    public static Process start(Path directory, Class<?> program, String... arguments) {
        File log = directory.resolve(program.getSimpleName() + ".log").toFile();
        try {
            return new ProcessBuilder(JavaProcess.command(program, arguments))
                    .redirectErrorStream(true)
                    .redirectOutput(ProcessBuilder.Redirect.appendTo(log))
                    .start();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Kills a process with SIGKILL, and waits until it has ended. */
    public static void kill(Process process) throws InterruptedException {
        process.destroyForcibly().waitFor();
    }
}
