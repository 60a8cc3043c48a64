package org.evoloop.roomba;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import org.awaitility.Awaitility;
import org.evoloop.JavaProcess;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** {@code roomba edge} in a process of its own; its robot in another. */
@Timeout(value = 300, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
@EnabledOnOs(OS.LINUX)
class EdgeProcessTest {
    /** Nothing listens there. */
    private static final String NO_BROKER = "mqtt://127.0.0.1:1";

    @TempDir
    private Path folder;

    @Test
    void aSignalIsAnOrdinaryWayToEnd() throws Exception {
        Path log = folder.resolve("log");
        try (OtherRobot robot = new OtherRobot()) {
            Process edge = Program.startWithLog(
                    log,
                    "edge",
                    "--port",
                    robot.port(),
                    "--device",
                    "robot",
                    "--mqtt",
                    NO_BROKER,
                    "--journal",
                    folder.resolve("journal").toString());
            try {
                Awaitility.await("it has begun")
                        .atMost(Duration.ofSeconds(120))
                        .until(() -> Files.readString(log).contains("nothing waits to be sent"));
                JavaProcess.signal("TERM", edge);
                assertThat(edge.waitFor()).as(Files.readString(log)).isZero();
                assertThat(robot.truth().isPassive()).isTrue();
            } finally {
                edge.destroyForcibly().waitFor();
            }
        }
    }
}
