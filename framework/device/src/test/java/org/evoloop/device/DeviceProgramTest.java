package org.evoloop.device;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.api.io.TempDir;

/** Device files that run as programs, against a device at a TCP port, or played. */
@Timeout(60)
class DeviceProgramTest {
    private static final String MODELS = """
            ## original

            ```mermaid
            stateDiagram-v2
                [*] --> Off
                Off --> On : power
                On --> Off : power
                On --> Off : «spontaneous» burnt
            ```

            ## new

            ```mermaid
            stateDiagram-v2
                [*] --> Off
                Off --> On : power
                On --> Off : power
                On --> Off : burnt
                Off --> Timed : timed
                On --> Timed : timed
                Timed : «device On»
                Timed --> Off : burnt
                Timed --> Off : power
                Timed --> On : lid opens
                Off --> On : warm [hot]
            ```
            """;

    private static final String LAMP = """
            converter: lamp
            models: {original: lamp.md#original, new: lamp.md#new}
            connections:
              lamp: {lines: "ADDRESS", greet: "?"}
            device:
              send: {power: {line: PWR, cost: 2}}
              answer: {ok: OK, error: ERR, within: 5 s}
              ask: {line: "?"}
              state: {is off: "Off", is on: "On"}
              does: [{line: "burnt (?<why>.*)", event: burnt}]
              readings: {temperature: {line: "T ([0-9]+)", unit: °C}}
            controller:
              press:
                - {values: {button power: power, button timed: timed}}
                - {line: "button warm", event: warm}
                - {values: {lid open: lid opens}}
            functions:
              Timed: {on-enter: {to: lamp, line: LED ON}, on-exit: {to: lamp, line: LED OFF}}
            guards:
              hot: {reading: temperature, above: 50}
            """;

    @RegisterExtension
    private final TypedConsole console = new TypedConsole();

    @TempDir
    private Path folder;

    @BeforeEach
    void draw() throws IOException {
        Files.writeString(folder.resolve("lamp.md"), MODELS);
    }

    private CompletableFuture<Integer> run(String address, String... options) throws IOException {
        Path file = Files.writeString(folder.resolve("lamp.yaml"), LAMP.replace("ADDRESS", address));
        return console.run(file, options);
    }

    @Test
    void aDeviceThatSpeaksInLinesIsConvertedWithoutJava() throws Exception {
        try (LineDevice lamp = new LineDevice(line -> line.equals("PWR") ? "OK" : line.equals("?") ? "is off" : "")) {
            CompletableFuture<Integer> status = run(lamp.address(), "--start");
            await().until(() -> lamp.heard().contains("?"));
            console.awaitStatus("lamp, running");
            lamp.tell("button timed");
            await().until(() -> lamp.heard().contains("LED ON"));
            assertThat(lamp.heard()).containsExactly("?", "PWR", "LED ON");
            lamp.tell("burnt out");
            await().until(() -> lamp.heard().contains("LED OFF"));
            lamp.tell("T 40");
            lamp.tell("button warm");
            lamp.tell("T 60");
            lamp.tell("button warm");
            await().until(() -> lamp.heard().stream().filter("PWR"::equals).count() == 2);
            console.awaitHistory("warm (controller)  (Off, Off) -> (On, On)");
            assertThat(console.printed())
                    .contains("timed (controller)  (Off, Off) -> (On, Timed)")
                    .contains("burnt");
            console.type("status");
            await().until(() -> console.printed().contains("temperature 60"));
            console.exit(status);
        }
    }

    @Test
    void aPlayedDeviceNeedsNoConnection() throws Exception {
        CompletableFuture<Integer> status = run("tcp://127.0.0.1:1", "--simulate", "--start");
        console.type("press timed");
        console.awaitHistory("timed (controller)  (Off, Off) -> (On, Timed)");
        await().until(() -> console.printed().contains("to lamp: LED ON"));
        console.type("press lid_opens");
        console.awaitHistory("lid opens (controller)  (On, Timed) -> (On, On)");
        console.type("press timed");
        console.awaitHistory("timed (controller)  (On, On) -> (On, Timed)");
        console.type("device burnt");
        console.awaitHistory("(On, Timed) -> (Off, Off)");
        console.type("press warm");
        console.awaitHistory("warm (controller)");
        console.exit(status);
    }
}
