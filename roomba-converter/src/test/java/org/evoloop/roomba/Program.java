package org.evoloop.roomba;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;

/** The program in a process of its own, started as by a user, except that it is not run from the jar. */
final class Program {
    private static final int PATIENCE_SECONDS = 120;

    /** The result. */
    record Result(int status, String out, String err) {}

    private Program() {}

    static Result run(Path folder, String... arguments) throws IOException, InterruptedException {
        return runWithInput(folder, "", arguments);
    }

    /** @param folder for what the program prints */
    static Result runWithInput(Path folder, String input, String... arguments)
            throws IOException, InterruptedException {
        return run(folder, List.of(), input, arguments);
    }

    /** On a machine without OpenCV. */
    static Result runWithoutOpenCv(Path folder, String... arguments) throws IOException, InterruptedException {
        Path empty = Files.createDirectories(folder.resolve("no-opencv"));
        return run(folder, List.of("-Devoloop.opencv.classes=" + empty), "", arguments);
    }

    /** With a log configuration file of the user's own. */
    static Result runWithLogFile(Path folder, Path logFile, String... arguments)
            throws IOException, InterruptedException {
        return run(folder, List.of("-Dlogback.configurationFile=" + logFile), "", arguments);
    }

    /** The running program, with its standard input open. */
    static Process start(List<String> javaOptions, String... arguments) throws IOException {
        return new ProcessBuilder(command(javaOptions, arguments))
                .redirectErrorStream(true)
                .start();
    }

    /** The same, with its output appended to {@code log}. */
    static Process startWithLog(Path log, String... arguments) throws IOException {
        return new ProcessBuilder(command(List.of(), arguments))
                .redirectErrorStream(true)
                .redirectOutput(ProcessBuilder.Redirect.appendTo(log.toFile()))
                .start();
    }

    private static Result run(Path folder, List<String> javaOptions, String input, String... arguments)
            throws IOException, InterruptedException {
        Path out = Files.createTempFile(folder, "out", ".txt");
        Path err = Files.createTempFile(folder, "err", ".txt");
        Process process = new ProcessBuilder(command(javaOptions, arguments))
                .redirectOutput(out.toFile())
                .redirectError(err.toFile())
                .start();
        try (Writer toProgram = process.outputWriter(StandardCharsets.UTF_8)) {
            toProgram.write(input);
        } catch (IOException endedEarly) {
            // A program that rejects its options reads no input.
            if (process.isAlive() && !process.waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS)) {
                throw new UncheckedIOException(endedEarly);
            }
        }
        if (!process.waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS)) {
            process.destroyForcibly();
            throw new AssertionError("did not end: " + Arrays.toString(arguments) + "\n" + Files.readString(out)
                    + Files.readString(err));
        }
        return new Result(process.exitValue(), Files.readString(out), Files.readString(err));
    }

    private static List<String> command(List<String> javaOptions, String... arguments) {
        // Without the tests' own settings, which silence the log.
        String classPath = Arrays.stream(System.getProperty("java.class.path").split(":"))
                .filter(entry -> !entry.endsWith("test-classes") && !entry.endsWith("test-classes/"))
                .collect(Collectors.joining(":"));
        List<String> command = new ArrayList<>(List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                // As in the program's manifest.
                "--enable-native-access=ALL-UNNAMED",
                "-XX:+UseSerialGC",
                "-XX:TieredStopAtLevel=1",
                "-Devoloop.home=" + System.getProperty("evoloop.root")));
        command.addAll(javaOptions);
        command.addAll(List.of("-cp", classPath, Main.class.getName()));
        command.addAll(List.of(arguments));
        return command;
    }
}
