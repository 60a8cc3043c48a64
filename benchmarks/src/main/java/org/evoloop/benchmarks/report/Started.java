package org.evoloop.benchmarks.report;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;

/**
 * A program that was started as {@code ./evoloop} does, until its first event.
 *
 * @param seconds from its start to the event
 * @param megabytes its peak resident memory
 */
public record Started(double seconds, double megabytes) {

    /**
     * Starts a program, and ends it.
     *
     * @param jar below the project's folder
     * @param typed at its console
     * @param shown in the line of its output that ends the first event
     * @param lives how long it lives after that, before its memory is measured
     * @throws IOException if it ends before
     */
    public static Started of(Path jar, List<String> arguments, String typed, String shown, Duration lives)
            throws IOException, InterruptedException {
        long begun = System.nanoTime();
        Process program = begin(jar, arguments.toArray(String[]::new));
        // A program without that event must not be waited for.
        CompletableFuture.delayedExecutor(1, TimeUnit.MINUTES).execute(program::destroyForcibly);
        try (Writer console = program.outputWriter(StandardCharsets.UTF_8);
                BufferedReader transcript =
                        new BufferedReader(new InputStreamReader(program.getErrorStream(), StandardCharsets.UTF_8));
                BufferedReader output = program.inputReader(StandardCharsets.UTF_8)) {
            console.write(typed);
            console.flush();
            awaitLine(output, transcript, shown);
            double seconds = (System.nanoTime() - begun) / 1e9;
            TimeUnit.NANOSECONDS.sleep(lives.toNanos());
            return new Started(seconds, ResidentMemory.of(program.pid()));
        } finally {
            program.destroy();
        }
    }

    /** The transcript goes to only one of the two streams, but both must be read. */
    private static void awaitLine(BufferedReader output, BufferedReader other, String end) throws IOException {
        for (String line = output.readLine(); line != null; line = output.readLine()) {
            if (line.contains(end)) {
                return;
            }
        }
        throw new IOException("the converter ended before its first event: " + other.readLine());
    }

    /** Starts a program of the project, with its archive of classes. */
    public static Process begin(Path jar, String... arguments) throws IOException {
        return begin(jar, List.of(), arguments);
    }

    /** The same with more options of the JVM. */
    public static Process begin(Path jar, List<String> jvmOptions, String... arguments) throws IOException {
        List<String> command = new ArrayList<>(
                List.of(Path.of(System.getProperty("java.home"), "bin", "java").toString()));
        String home = System.getProperty("evoloop.home", "");
        String archive = String.valueOf(jar.getFileName()).replace(".jar", ".jsa");
        command.addAll(Fork.SHIPPED_OPTIONS);
        command.addAll(jvmOptions);
        command.add("-XX:SharedArchiveFile=" + Path.of(home, "target", archive));
        command.add("-Xlog:cds=off");
        command.add("-Xlog:cds+dynamic=off");
        command.add("-Devoloop.home=" + home);
        command.addAll(List.of("-jar", Path.of(home).resolve(jar).toString()));
        command.addAll(List.of(arguments));
        return new ProcessBuilder(command).start();
    }

    /** The median of the seconds. */
    public static double medianSeconds(List<Started> all) {
        double[] sorted = all.stream().mapToDouble(Started::seconds).sorted().toArray();
        return sorted[sorted.length / 2];
    }

    /** The most memory that any of them took. */
    public static double mostMegabytes(List<Started> all) {
        return all.stream().mapToDouble(Started::megabytes).max().orElse(0);
    }
}
