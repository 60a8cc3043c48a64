package org.evoloop.lightbulb;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.assertj.core.api.InstanceOfAssertFactories;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** What the program logs if standard error is a file, or systemd's journal. */
@EnabledOnOs(OS.LINUX)
@Timeout(60)
class LogTest {
    /** A broker that the program warns about. */
    private static final String[] UNREACHABLE = {"--mqtt", "mqtt://127.0.0.1:1"};

    @TempDir
    private Path folder;

    private List<String> log(boolean inJournal, int status, String... options) throws Exception {
        Path log = Files.createFile(folder.resolve("log"));
        ProcessBuilder program = new ProcessBuilder(MainTest.command(options))
                .directory(new File(System.getProperty("evoloop.root", "..")))
                .redirectOutput(ProcessBuilder.Redirect.DISCARD)
                .redirectError(log.toFile());
        if (inJournal) {
            program.environment()
                    .put(
                            "JOURNAL_STREAM",
                            Files.getAttribute(log, "unix:dev") + ":" + Files.getAttribute(log, "unix:ino"));
        }
        Process lamp = program.start();
        try {
            while (Files.size(log) == 0 && !lamp.waitFor(100, TimeUnit.MILLISECONDS)) {}
            lamp.outputWriter().close();
            assertThat(lamp.waitFor(20, TimeUnit.SECONDS)).isTrue();
            assertThat(lamp.exitValue()).isEqualTo(status);
        } finally {
            lamp.destroyForcibly();
        }
        return Files.readAllLines(log);
    }

    @Test
    void systemdsJournalGetsTheLevelOfEachLine() throws Exception {
        assertThat(log(true, 0, UNREACHABLE)).isNotEmpty().allMatch(line -> line.startsWith("<4>"));
    }

    @Test
    void aFileGetsTimeAndLevel() throws Exception {
        assertThat(log(false, 0, UNREACHABLE)).isNotEmpty().allMatch(line -> line.matches("[0-9:.]{12} WARN  .*"));
    }

    @Test
    void whyAProgramEndsIsAnErrorInSystemdsJournal() throws Exception {
        assertThat(log(true, 2, "--quite", "--wrong"))
                .hasSizeGreaterThan(1)
                .allMatch(line -> line.startsWith("<3>"))
                .first(InstanceOfAssertFactories.STRING)
                .startsWith("<3>error: ");
    }

    @Test
    void whyAProgramEndsIsPlainElsewhere() throws Exception {
        assertThat(log(false, 2, "--models", "missing.xml"))
                .first(InstanceOfAssertFactories.STRING)
                .startsWith("error: ");
    }
}
