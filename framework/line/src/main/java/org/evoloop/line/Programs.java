package org.evoloop.line;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.evoloop.time.Threads;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Starts and ends other programs, without a shell. */
final class Programs {
    private static final Logger LOG = LoggerFactory.getLogger(LineConnection.class);
    private static final int GRACE_SECONDS = 2;

    /** Keeps the terminal's signals from a program: Ctrl-C is for this one, which ends its programs in its own order. */
    private static final Path OWN_SESSION = Path.of("/usr/bin/setsid");

    private Programs() {}

    /**
     * Checks a command.
     *
     * @throws IllegalArgumentException if it cannot be started on any machine
     */
    static List<String> requireCommand(List<String> command) {
        if (command.isEmpty() || command.get(0).isBlank() || command.stream().anyMatch(each -> each.contains("\0"))) {
            throw new IllegalArgumentException(
                    "the command names no program; give one and its arguments, such as [python3, kettle.py]");
        }
        return List.copyOf(command);
    }

    /**
     * Starts a program. What it writes to its standard error is logged.
     *
     * @param builder its command, folder and input and output
     * @throws IOException if it cannot be started; the message says how to fix it
     */
    static Process start(ProcessBuilder builder, String name) throws IOException {
        List<String> command = builder.command();
        if (Files.isExecutable(OWN_SESSION) && isFound(command.get(0))) {
            List<String> alone = new ArrayList<>(List.of(OWN_SESSION.toString()));
            alone.addAll(command);
            builder.command(alone);
        }
        Process process;
        try {
            process = builder.start();
        } catch (IOException failure) {
            throw new IOException(
                    name + " cannot be started (" + failure.getMessage()
                            + "); check its path, and that this user may execute it",
                    failure);
        }
        Threads.start("program-errors", () -> logErrors(process, name));
        return process;
    }

    private static boolean isFound(String program) {
        String folders = program.contains("/") ? "" : System.getenv().getOrDefault("PATH", "");
        return Stream.of(folders.split(File.pathSeparator))
                .map(folder -> Path.of(folder).resolve(program))
                .anyMatch(file -> Files.isRegularFile(file) && Files.isExecutable(file));
    }

    private static void logErrors(Process process, String name) {
        try {
            LineReader lines = new LineReader(process.getErrorStream(), about -> {});
            for (String line = lines.next(); line != null; line = lines.next()) {
                LOG.warn("{}: {}", name, line);
            }
        } catch (IOException ended) {
            // With the program.
        }
    }

    /** Ends a program and those that it has started, at first politely. */
    static void end(Process process) {
        List<ProcessHandle> all = all(process);
        all.forEach(ProcessHandle::destroy);
        boolean interrupted = false;
        try {
            process.waitFor(GRACE_SECONDS, TimeUnit.SECONDS);
        } catch (InterruptedException hurry) {
            interrupted = true;
        }
        all.forEach(ProcessHandle::destroyForcibly);
        if (interrupted) {
            Thread.currentThread().interrupt();
        }
    }

    /** Ends them at once. */
    static void kill(Process process) {
        all(process).forEach(ProcessHandle::destroyForcibly);
    }

    private static List<ProcessHandle> all(Process process) {
        return Stream.concat(process.descendants(), Stream.of(process.toHandle()))
                .toList();
    }

    /** For messages: a program, and the file that it is given first, such as a script; other arguments may be secret. */
    static String name(List<String> command) {
        Path file = Path.of(command.get(0)).getFileName();
        boolean script = command.size() > 1 && Files.isRegularFile(Path.of(command.get(1)));
        return "the program " + (file == null ? command.get(0) : file) + (script ? " " + command.get(1) : "");
    }
}
