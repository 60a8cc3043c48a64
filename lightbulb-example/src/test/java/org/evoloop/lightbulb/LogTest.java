package org.evoloop.lightbulb;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** What the program logs, whose standard error is a file that may be systemd's journal. */
@EnabledOnOs(OS.LINUX)
@Timeout(60)
class LogTest {
    @TempDir
    private Path folder;

    /** Of a broker that cannot be reached the program warns. */
    private List<String> log(boolean inJournal) throws Exception {
        Path log = Files.createFile(folder.resolve("log"));
        String classPath = Arrays.stream(System.getProperty("java.class.path").split(File.pathSeparator))
                .filter(entry -> !entry.endsWith("test-classes"))
                .collect(Collectors.joining(File.pathSeparator));
        ProcessBuilder program = new ProcessBuilder(
                        System.getProperty("java.home") + "/bin/java",
                        "-XX:+UseSerialGC",
                        "-XX:TieredStopAtLevel=1",
                        "-cp",
                        classPath,
                        Main.class.getName(),
                        "--mqtt",
                        "mqtt://127.0.0.1:1")
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
            while (Files.size(log) == 0) {
                assertThat(lamp.waitFor(100, TimeUnit.MILLISECONDS)).isFalse();
            }
            lamp.outputWriter().close();
            assertThat(lamp.waitFor(20, TimeUnit.SECONDS)).isTrue();
        } finally {
            lamp.destroyForcibly();
        }
        return Files.readAllLines(log);
    }

    @Test
    void systemdsJournalIsToldTheLevelOfEachLine() throws Exception {
        assertThat(log(true)).isNotEmpty().allMatch(line -> line.startsWith("<4>"));
    }

    @Test
    void aFileIsToldTimeAndLevel() throws Exception {
        assertThat(log(false)).isNotEmpty().allMatch(line -> line.matches("[0-9:.]{12} WARN  .*"));
    }
}
