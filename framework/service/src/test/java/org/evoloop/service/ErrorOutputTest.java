package org.evoloop.service;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.Charset;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

@EnabledOnOs(OS.LINUX)
class ErrorOutputTest {
    @Test
    void onlyTheStreamThatSystemdHasOpenedIsTheJournal(@TempDir Path folder) throws Exception {
        Path stream = Files.createFile(folder.resolve("journal"));
        Path link = Files.createSymbolicLink(folder.resolve("fd"), stream);
        Path other = Files.createFile(folder.resolve("file"));
        String variable = Files.getAttribute(stream, "unix:dev") + ":" + Files.getAttribute(stream, "unix:ino");

        assertThat(ErrorOutput.isJournal(link, variable)).isTrue();
        assertThat(ErrorOutput.isJournal(other, variable)).as("redirected").isFalse();
        assertThat(ErrorOutput.isJournal(stream, null)).as("not under systemd").isFalse();
        assertThat(ErrorOutput.isJournal(stream, "nonsense")).isFalse();
        assertThat(ErrorOutput.isJournal(folder.resolve("closed"), variable)).isFalse();
    }

    @Test
    void everyLineInTheJournalBeginsWithTheLevelOfAnError() {
        ByteArrayOutputStream journal = new ByteArrayOutputStream();

        ErrorOutput.levelled(new PrintStream(journal, true)).println("error: Tür:1: 'x' is unknown\n       remove it");

        // Not every locale has the letter.
        assertThat(journal.toByteArray())
                .isEqualTo("<3>error: Tür:1: 'x' is unknown\n<3>       remove it\n".getBytes(Charset.defaultCharset()));
    }
}
