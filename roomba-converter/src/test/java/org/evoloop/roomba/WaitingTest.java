package org.evoloop.roomba;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.concurrent.TimeUnit;
import org.awaitility.Awaitility;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** A service whose robot is not yet connected. */
@EnabledOnOs(OS.LINUX)
@Timeout(180)
class WaitingTest {
    @TempDir
    private Path folder;

    @Test
    void aServiceWaitsForItsRobotAndSaysSoOnce() throws Exception {
        Path log = folder.resolve("log");
        Path port = folder.resolve("robot");
        Process converter = Program.startWithLog(log, "--port", port.toString(), "--start");
        try {
            awaitLog(log, "does not exist");
            OtherRobot.type(converter, "status\n");
            awaitLog(log, "converter   roomba, running");
            assertThat(Files.readString(log).lines().filter(line -> line.contains("; waiting for it")))
                    .hasSize(1);
            Process robot = Program.startWithLog(folder.resolve("robot.log"), "simulator", "--link", port.toString());
            try {
                Awaitility.await().atMost(Duration.ofSeconds(60)).until(() -> {
                    OtherRobot.type(converter, "press clean\n");
                    return Files.readString(log).contains("Clean command");
                });
            } finally {
                robot.destroy();
            }
        } finally {
            converter.destroy();
            assertThat(converter.waitFor(60, TimeUnit.SECONDS)).isTrue();
        }
        assertThat(Files.readString(log)).doesNotContain("Exception");
    }

    private static void awaitLog(Path log, String text) {
        Awaitility.await(text)
                .atMost(Duration.ofSeconds(60))
                .until(() -> read(log).contains(text));
    }

    private static String read(Path log) throws IOException {
        return Files.exists(log) ? Files.readString(log) : "";
    }
}
