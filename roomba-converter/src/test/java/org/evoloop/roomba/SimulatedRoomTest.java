package org.evoloop.roomba;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** The room of {@code --simulate}. */
@EnabledOnOs(OS.LINUX)
@Timeout(240)
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
            OtherRobot.type(roomba, "press clean\n");
            await().atMost(150, TimeUnit.SECONDS)
                    .pollInterval(2, TimeUnit.SECONDS)
                    .until(() -> isDockedOrSentThere(roomba, log));
        } finally {
            roomba.destroy();
            assertThat(roomba.waitFor(60, TimeUnit.SECONDS)).isTrue();
        }
    }

    /** Presses again what a robot in doubt did not take, as its owner would: a busy computer may keep it in doubt. */
    private static boolean isDockedOrSentThere(Process roomba, Path log) throws Exception {
        List<String> states = Files.readAllLines(log).stream()
                .map(String::strip)
                .filter(line -> line.startsWith("new_current_state: "))
                .toList();
        if (states.contains("new_current_state: Charging")) {
            return true;
        }
        String newest = states.isEmpty() ? "" : states.get(states.size() - 1);
        if (newest.endsWith(" Off")) {
            OtherRobot.type(roomba, "press clean\n");
        } else if (newest.endsWith(" On") || newest.endsWith(" Clean")) {
            OtherRobot.type(roomba, "press dock\n");
        }
        return false;
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
