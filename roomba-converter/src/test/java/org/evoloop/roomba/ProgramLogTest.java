package org.evoloop.roomba;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** Where the log goes, observed from outside. */
@EnabledOnOs(OS.LINUX)
@Timeout(180)
class ProgramLogTest {
    private static final String[] DEMO = {"demo", "--scenario", "timeout", "--speed", "20"};

    @TempDir
    Path folder;

    @Test
    void theTranscriptGoesToStandardOutputByItself() throws Exception {
        assertThat(Program.run(folder, DEMO).out().lines()).contains("Monitor", " inputs timeout event.");
    }

    @Test
    void aFileThatTheUserGivesWins() throws Exception {
        Path mine = Files.writeString(folder.resolve("mine.xml"), """
                <configuration>
                  <appender name="MINE" class="ch.qos.logback.core.ConsoleAppender">
                    <target>System.err</target>
                    <encoder><pattern>mine: %msg%n</pattern></encoder>
                  </appender>
                  <logger name="org.evoloop.transcript" level="INFO"><appender-ref ref="MINE"/></logger>
                </configuration>
                """);

        Program.Result result = Program.runWithLogFile(folder, mine, DEMO);

        assertThat(result.err().lines()).contains("mine: Monitor", "mine:  inputs timeout event.");
        assertThat(result.out().lines()).doesNotContain("Monitor");
        assertThat(result.status()).isZero();
    }
}
