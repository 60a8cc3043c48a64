package org.evoloop.benchmarks.report;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDate;
import java.time.ZoneOffset;
import java.util.List;

/**
 * The origin of figures.
 *
 * <p>Threading: immutable.
 *
 * @param machine where they were measured: JDK, processors and operating system
 * @param commit what was measured; with {@code -dirty} at its end if there were uncommitted changes
 * @param day when, in UTC, as {@code 2026-11-21}
 */
public record Origin(String machine, String commit, String day) {
    private static final String UNKNOWN = "unknown";

    /** This machine, the commit of the project's folder, and today. */
    public static Origin here() throws InterruptedException {
        return new Origin(
                thisMachine(), thisCommit(), LocalDate.now(ZoneOffset.UTC).toString());
    }

    private static String thisMachine() {
        return "JDK " + Runtime.version() + ", " + processor()
                + Runtime.getRuntime().availableProcessors() + " processors, " + System.getProperty("os.name") + " "
                + System.getProperty("os.version") + " " + System.getProperty("os.arch");
    }

    /** The processor's model name and a comma; empty if it is unknown. */
    private static String processor() {
        try (var lines = Files.lines(Path.of("/proc/cpuinfo"))) {
            return lines.filter(line -> line.startsWith("model name"))
                    .findFirst()
                    .map(line -> line.substring(line.indexOf(':') + 1).trim() + ", ")
                    .orElse("");
        } catch (IOException noGit) {
            return "";
        }
    }

    /** A copy of the project without its history has no commit. */
    private static String thisCommit() throws InterruptedException {
        List<String> command = List.of(
                "git", "-C", System.getProperty("evoloop.home", "."), "describe", "--always", "--dirty", "--exclude=*");
        try {
            Process git = new ProcessBuilder(command)
                    .redirectError(ProcessBuilder.Redirect.DISCARD)
                    .start();
            String output = new String(git.getInputStream().readAllBytes(), StandardCharsets.UTF_8).trim();
            return git.waitFor() == 0 ? output : UNKNOWN;
        } catch (IOException noGit) {
            return UNKNOWN;
        }
    }
}
