package org.evoloop.benchmarks;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class MainTest {
    private final StringWriter errors = new StringWriter();

    private int run(String... arguments) {
        return Main.commandLine().setErr(new PrintWriter(errors, true)).execute(arguments);
    }

    @Test
    void namesAnOptionThatThereIsNot() {
        assertThat(run("--slowly")).isEqualTo(2);
        assertThat(errors.toString()).contains("--slowly").contains("./evoloop bench --help");
    }

    @Test
    void saysBeforeItMeasuresThatTheFileCannotBeWritten(@TempDir Path directory) {
        Path file = directory.resolve("missing").resolve("results.json");

        assertThat(run("--json", file.toString())).isEqualTo(2);
        assertThat(errors.toString())
                .isEqualToIgnoringNewLines(
                        "error: --json: cannot write " + file + "; name a file in a directory that exists");
    }

    @Test
    void drawsTheResultsOfARun(@TempDir Path directory) throws IOException {
        Path kept = Path.of(System.getProperty("evoloop.root"), "benchmarks", "results", "2026-11-21.json");
        Path picture = directory.resolve("plot.svg");

        assertThat(run("plot", kept.toString(), picture.toString())).isZero();
        String commit = Files.readString(kept).replaceFirst("(?s).*\"commit\" *: *\"([0-9a-f]+).*", "$1");
        assertThat(commit).hasSizeLessThan(41);
        assertThat(picture).content().startsWith("<svg ").contains("commit " + commit);
    }

    @Test
    void saysThatThePictureCannotBeWritten(@TempDir Path directory) {
        Path kept = Path.of(System.getProperty("evoloop.root"), "benchmarks", "results", "2026-11-21.json");
        Path picture = directory.resolve("missing").resolve("plot.svg");

        assertThat(run("plot", kept.toString(), picture.toString())).isEqualTo(2);
        assertThat(errors.toString())
                .isEqualToIgnoringNewLines(
                        "error: cannot write " + picture + "; name a file in a directory that exists");
    }

    @Test
    void saysBeforeItRecordsThatThereIsNoFolder(@TempDir Path directory) {
        Path folder = directory.resolve("missing");

        assertThat(run("profile", "--flame-graphs", folder.toString())).isEqualTo(2);
        assertThat(errors.toString())
                .isEqualToIgnoringNewLines("error: --flame-graphs: there is no folder " + folder + "; make it");
    }

    @Test
    void namesWorkThatThereIsNot() {
        assertThat(run("profile", "laundry")).isEqualTo(2);
        assertThat(errors.toString())
                .isEqualToIgnoringNewLines(
                        "error: there is no work laundry to look at; there are [decision, conversion, threads]");
    }
}
