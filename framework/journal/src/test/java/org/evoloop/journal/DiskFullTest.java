package org.evoloop.journal;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** A process that may not write files as large as a segment gets no journal, and leaves no files behind. */
@EnabledOnOs({OS.LINUX, OS.MAC})
class DiskFullTest {
    @TempDir
    private Path directory;

    @Test
    void aSegmentForWhichThereIsNoRoomIsRefused() throws Exception {
        Path journal = directory.resolve("journal");
        Process process = new ProcessBuilder(
                        "bash",
                        "-c",
                        "ulimit -f 20; exec \"$0\" \"$@\"",
                        Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                        "-XX:TieredStopAtLevel=1",
                        "-XX:-UsePerfData",
                        "-cp",
                        System.getProperty("java.class.path"),
                        KilledConverter.class.getName(),
                        journal.toString(),
                        Forcing.BY_BATCH.name())
                .start();
        String error = new String(process.getErrorStream().readAllBytes(), StandardCharsets.UTF_8);
        assertThat(process.waitFor(1, TimeUnit.MINUTES)).isTrue();

        assertThat(error)
                .contains("the journal " + journal + " cannot be written: File too large; make it a directory that this"
                        + " user may write to, with room on its disk, or use another");
        assertThat(Directory.segments(journal)).isEmpty();
        assertThat(Files.exists(journal)).isTrue();
    }
}
