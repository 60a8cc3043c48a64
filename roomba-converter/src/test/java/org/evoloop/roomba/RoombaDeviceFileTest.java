package org.evoloop.roomba;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.InterruptedIOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.LinkedBlockingQueue;
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

    private final BlockingQueue<Byte> typed = new LinkedBlockingQueue<>();
    private final ByteArrayOutputStream printed = new ByteArrayOutputStream();

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

    /** Its events are sent, its functions run, and they end with their state. */
    @Test
    void itRunsWithASimulatedRobot() throws Exception {
        InputStream in = System.in;
        PrintStream out = System.out;
        try {
            System.setIn(new Typed());
            System.setOut(new PrintStream(printed, true, StandardCharsets.UTF_8));
            CompletableFuture<Integer> status =
                    CompletableFuture.supplyAsync(() -> DeviceProgram.run(FILE, List.of("--simulate", "--start")));
            awaitAnswer("status", "link        up");
            type("press Clean");
            awaitAnswer("history", "(Off, Off) -> (On, On)");
            awaitAnswer("robot state", "\"activity\":\"on\"");
            type("press Spot");
            awaitAnswer("status", "driving to the starting point");
            type("press Power");
            awaitAnswer("history", "(On, Move) -> (Off, Off)");
            type("exit");
            assertThat(status.get(PATIENCE.toSeconds(), TimeUnit.SECONDS)).isZero();
        } finally {
            System.setIn(in);
            System.setOut(out);
        }
    }

    private void awaitAnswer(String command, String answer) {
        await(answer).atMost(PATIENCE).pollInterval(Duration.ofMillis(500)).until(() -> {
            type(command);
            return printed.toString(StandardCharsets.UTF_8).contains(answer);
        });
    }

    private void type(String line) {
        for (byte each : (line + "\n").getBytes(StandardCharsets.UTF_8)) {
            typed.add(each);
        }
    }

    /** What is typed, whichever threads read it. */
    private final class Typed extends InputStream {
        @Override
        public int read() throws IOException {
            try {
                return typed.take();
            } catch (InterruptedException end) {
                throw new InterruptedIOException();
            }
        }

        @Override
        public int read(byte[] bytes, int from, int most) throws IOException {
            bytes[from] = (byte) read();
            return 1;
        }
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
