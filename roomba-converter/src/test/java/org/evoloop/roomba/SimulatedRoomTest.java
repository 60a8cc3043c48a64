package org.evoloop.roomba;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** The room of {@code --simulate}. */
@EnabledOnOs(OS.LINUX)
@Timeout(180)
class SimulatedRoomTest {
    private static final String MODELS = Path.of(System.getProperty("evoloop.root"), "models/roomba.xml") + "#";

    @TempDir
    private Path folder;

    @Test
    void withTheModelsOfAHomeTheRobotFindsItsDock() throws Exception {
        Path log = folder.resolve("log");
        Process roomba = Program.startWithLog(
                log,
                "--simulate",
                "--speed=20",
                "--start",
                "--original=" + MODELS + "original",
                "--new=" + MODELS + "home");
        try {
            OtherRobot.type(roomba, "press clean\npress dock\n");
            await().atMost(120, TimeUnit.SECONDS)
                    .until(() -> Files.readString(log).contains("new_current_state: Charging"));
        } finally {
            roomba.destroy();
            assertThat(roomba.waitFor(60, TimeUnit.SECONDS)).isTrue();
        }
    }

    @Test
    void aRoomOfOnesOwnIsReadFromItsFile() throws Exception {
        Path room = Files.writeString(folder.resolve("room.txt"), "wall -1000 -1000 1000 1000\nstart 400 -200 90\n");
        Program.Result result =
                Program.runWithInput(folder, "robot state\n", "--simulate", "--speed=20", "--room=" + room);
        assertThat(result.out()).contains("\"xMm\":400").contains("\"yMm\":-200");
        assertThat(result.status()).isZero();
    }
}
