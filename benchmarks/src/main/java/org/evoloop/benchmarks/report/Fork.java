package org.evoloop.benchmarks.report;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;

/**
 * A separate JVM to measure in, so that earlier measurements have not warmed it up or filled its caches. It prints its
 * results as lines of a name and a number.
 */
public final class Fork {
    /** The options with which {@code ./evoloop} and the package start programs. */
    public static final List<String> SHIPPED_OPTIONS = shipped("jvm.options");

    /** Those with which the studio is started, after the others. */
    public static final List<String> STUDIO_OPTIONS = shipped("studio.options");

    private static final long LIMIT_MINUTES = 20;

    private final List<String> command = new ArrayList<>();

    private static List<String> shipped(String file) {
        Path share = Path.of(System.getProperty("evoloop.home", ""), "framework/package/root/usr/share/evoloop");
        return List.of("@" + share.resolve(file));
    }

    private Fork() {
        command.add(new File(System.getProperty("java.home"), "bin/java").getPath());
    }

    /** A JVM that runs {@code main}, with this program's class path. */
    public static Fork of(Class<?> main, List<String> jvmOptions, String... arguments) {
        Fork fork = new Fork();
        fork.command.addAll(jvmOptions);
        fork.command.addAll(List.of("-cp", System.getProperty("java.class.path"), main.getName()));
        fork.command.addAll(List.of(arguments));
        return fork;
    }

    /**
     * A JVM that runs {@code main} as {@code ./evoloop} would: with an archive of the classes that a short run needs.
     *
     * @param shortRun the short run's arguments
     * @throws IOException if the short run fails
     */
    public static Fork shipped(Class<?> main, List<String> shortRun, String... arguments)
            throws IOException, InterruptedException {
        Path folder = Files.createTempDirectory("evoloop");
        Path archive = folder.resolve("classes.jsa");
        // The last one registered is deleted first.
        folder.toFile().deleteOnExit();
        archive.toFile().deleteOnExit();
        run(of(main, shippedWith("-XX:ArchiveClassesAtExit=" + archive), shortRun.toArray(String[]::new)).command);
        return of(main, shippedWith("-XX:SharedArchiveFile=" + archive), arguments);
    }

    private static List<String> shippedWith(String archiveOption) {
        List<String> options = new ArrayList<>(SHIPPED_OPTIONS);
        // Warnings about classes that cannot be archived are irrelevant, and would be printed among the figures.
        options.addAll(List.of(archiveOption, "-Xlog:cds=off", "-Xlog:cds+dynamic=off"));
        return options;
    }

    /** A JVM with only these arguments. */
    public static Fork java(String... arguments) {
        Fork fork = new Fork();
        fork.command.addAll(List.of(arguments));
        return fork;
    }

    /**
     * Runs it to its end.
     *
     * @return the lines of a name and a number that it printed
     * @throws IOException if it fails
     */
    public Figures figures() throws IOException, InterruptedException {
        return Figures.parse(run(command));
    }

    /** The processor time of the whole process from start to end, in seconds, including time in the kernel. */
    public double cpuSeconds() throws IOException, InterruptedException {
        double[] userAndSystem = times("%U %S");
        return userAndSystem[0] + userAndSystem[1];
    }

    /** The wall time from start to end, in seconds. */
    public double wallSeconds() throws IOException, InterruptedException {
        return times("%R")[0];
    }

    private double[] times(String format) throws IOException, InterruptedException {
        List<String> timed = new ArrayList<>(List.of(
                "bash", "-c", "export LC_ALL=C; TIMEFORMAT='" + format + "'; time \"$@\" >/dev/null 2>&1", "-"));
        timed.addAll(command);
        List<String> numbers = List.of(run(timed).trim().split(" ", -1));
        double[] seconds = new double[numbers.size()];
        for (int index = 0; index < numbers.size(); index++) {
            seconds[index] = Double.parseDouble(numbers.get(index));
        }
        return seconds;
    }

    private static String run(List<String> command) throws IOException, InterruptedException {
        Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
        String output = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        if (!process.waitFor(LIMIT_MINUTES, TimeUnit.MINUTES) || process.exitValue() != 0) {
            process.destroyForcibly();
            throw new IOException("a measurement failed: " + String.join(" ", command) + "\n" + output);
        }
        return output;
    }
}
