package org.evoloop.roomba;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;

import java.io.ByteArrayOutputStream;
import java.io.InputStream;
import java.io.PipedInputStream;
import java.io.PipedOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.evoloop.device.DeviceFile;
import org.evoloop.device.DeviceProgram;
import org.evoloop.device.Scenario;
import org.evoloop.device.file.DeviceFileException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** The Roomba's converter as a device file. */
@Timeout(120)
class RoombaDeviceFileTest {
    private static final Path FILE =
            Path.of(System.getProperty("evoloop.root", "..")).resolve("devices/roomba/roomba.yaml");
    private static final Duration PATIENCE = Duration.ofSeconds(60);

    @TempDir
    private Path folder;

    @Test
    void itsScenariosPass() {
        DeviceFile file = DeviceFile.read(FILE, DeviceProgram.options());
        assertThat(file.scenarios()).hasSizeGreaterThan(1);
        for (Scenario scenario : file.scenarios()) {
            assertThat(scenario.run(file)).as(scenario.name()).isEmpty();
        }
        assertThat(file.sent()).containsExactlyInAnyOrder("Clean", "Spot", "Dock", "Max", "Power", "Undock");
    }

    /** Its buttons are heard, its functions run, and they end with their state. */
    @Test
    void itRunsWithASimulatedRobot() throws Exception {
        InputStream in = System.in;
        PrintStream out = System.out;
        ByteArrayOutputStream printed = new ByteArrayOutputStream();
        try (PipedOutputStream keys = new PipedOutputStream();
                PrintStream typed = new PrintStream(keys, true, StandardCharsets.UTF_8)) {
            System.setIn(new PipedInputStream(keys));
            System.setOut(new PrintStream(printed, true, StandardCharsets.UTF_8));
            CompletableFuture<Integer> status =
                    CompletableFuture.supplyAsync(() -> DeviceProgram.run(FILE, List.of("--simulate", "--start")));
            await().atMost(PATIENCE).until(() -> says("status", "link        up", typed, printed));
            typed.println("robot press clean");
            await().atMost(PATIENCE)
                    .until(() -> says("history", "Clean (panel, the device acted)  (Off, Off)", typed, printed));
            typed.println("press Spot");
            await().atMost(PATIENCE).until(() -> says("status", "driving to the starting point", typed, printed));
            typed.println("press Power");
            await().atMost(PATIENCE).until(() -> says("history", "(On, Move) -> (Off, Off)", typed, printed));
            typed.println("exit");
            assertThat(status.get(PATIENCE.toSeconds(), TimeUnit.SECONDS)).isZero();
        } finally {
            System.setIn(in);
            System.setOut(out);
        }
    }

    private static boolean says(String command, String answer, PrintStream typed, ByteArrayOutputStream printed) {
        typed.println(command);
        return printed.toString(StandardCharsets.UTF_8).contains(answer);
    }

    @Test
    void withoutModelsItHasAllThatARoombaHas() throws Exception {
        Path file = Files.writeString(folder.resolve("roomba.yaml"), """
                converter: roomba
                connections: {robot: {roomba: /dev/ttyUSB0}}
                """);
        assertThat(DeviceFile.read(file, DeviceProgram.options()).sent()).contains("Clean", "Spot", "Dock");
    }

    @Test
    void eachMistakeIsInItsLine() throws Exception {
        Path file = Files.writeString(folder.resolve("roomba.yaml"), """
                converter: roomba
                connections:
                  robot: {roomba: /dev/ttyUSB0, start-point: here, mode-ofset: 1}
                device:
                  send: {Blow: {to: robot}}
                functions:
                  Move: {elsewhere: robot, function: Mov}
                """);
        assertThatThrownBy(() -> DeviceFile.read(file, DeviceProgram.options()))
                .isInstanceOf(DeviceFileException.class)
                .hasMessageContaining(":3: start-point: 'here' is no point; write X,Y in mm")
                .hasMessageContaining(":3: 'mode-ofset' is not known in connections.robot; did you mean mode-offset?")
                .hasMessageContaining(":5: a Roomba has no command for 'Blow'")
                .hasMessageContaining(":7: a Roomba has no function 'Mov'; did you mean Move?");
    }
}
