package org.evoloop.device;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.api.io.TempDir;

/** A converter that began without models gets them while it runs. */
@Timeout(60)
class DeviceReloadTest {
    private static final String MODELS = """
            ## original

            ```mermaid
            stateDiagram-v2
                [*] --> Off
                Off --> On : power
                On --> Off : power
            ```

            ## new

            ```mermaid
            stateDiagram-v2
                [*] --> Off
                Off --> On : power
                On --> Off : power
                Off --> Timed : timed
                Timed : «device On»
                Timed --> Off : power
            ```
            """;

    private static final String WIRING = """
            converter: lamp
            connections: {lamp: {lines: "ADDRESS", greet: "?"}}
            device:
              send: {power: PWR}
              answer: {within: 20 s}
            controller:
              press: {button power: power, button timed: timed}
            """;

    private static final String BEHAVIOUR = """
            models: {original: lamp.md#original, new: lamp.md#new}
            functions:
              Timed: {on-enter: {to: lamp, line: LED ON}, on-exit: {to: lamp, line: LED OFF}}
            """;

    @RegisterExtension
    private final TypedConsole console = new TypedConsole();

    private final PrintStream err = System.err;
    private final ByteArrayOutputStream complaints = new ByteArrayOutputStream();

    @TempDir
    private Path folder;

    @BeforeEach
    void listen() throws IOException {
        System.setErr(new PrintStream(complaints, true, StandardCharsets.UTF_8));
        Files.writeString(folder.resolve("lamp.md"), MODELS);
    }

    @AfterEach
    void restore() {
        System.setErr(err);
    }

    private Path write(String text, LineDevice lamp) throws IOException {
        return Files.writeString(folder.resolve("lamp.yaml"), text.replace("ADDRESS", lamp.address()));
    }

    private void awaitComplaint(String text) {
        await(text).until(() -> complaints.toString(StandardCharsets.UTF_8).contains(text));
    }

    @Test
    void modelsAndFunctionsAreTakenOverAndConnectionsAreNot() throws Exception {
        try (LineDevice lamp = new LineDevice(line -> line.equals("PWR") ? "OK" : "")) {
            CompletableFuture<Integer> status = console.run(write(WIRING, lamp), "--start");
            console.awaitStatus("link        up");
            lamp.tell("button timed");
            lamp.tell("button power");
            console.awaitHistory("power (controller)  in (Any, Any)  handled");

            write(WIRING.replace("PWR", "SPD") + BEHAVIOUR.replace("Timed:", "Tined:"), lamp);
            console.type("reload");
            awaitComplaint("lamp.yaml:10: 'Tined' is not a state of the new model; did you mean Timed?");
            write(WIRING.replace("PWR", "SPD").replace("greet: \"?\"", "greet: \"!\"") + BEHAVIOUR, lamp);
            console.type("reload");
            awaitComplaint("lamp.yaml:2: 'connections' has changed, which a running converter cannot take over");
            awaitComplaint("lamp.yaml:3: 'device' has changed");

            write("# drawn\n" + WIRING + BEHAVIOUR, lamp);
            console.type("reload");
            await().until(() -> console.printed().contains("evolved to 'new': (Any, Any) is (Off, Off)"));
            lamp.tell("button timed");
            await().until(() -> lamp.heard().contains("LED ON"));
            console.awaitHistory("timed (controller)  (Off, Off) -> (On, Timed)");
            lamp.tell("button power");
            await().until(() -> lamp.heard().contains("LED OFF"));
            assertThat(lamp.heard()).containsExactly("?", "PWR", "PWR", "LED ON", "LED OFF", "PWR");
            assertThat(lamp.heard().stream().filter("?"::equals)).hasSize(1);

            write(WIRING + BEHAVIOUR.replace("LED ON", "LED BLUE"), lamp);
            console.type("reload");
            await().until(() -> console.printed().contains("evolved to 'new': (Off, Off) is (Off, Off)"));
            lamp.tell("button timed");
            await().until(() -> lamp.heard().contains("LED BLUE"));
            console.exit(status);
        }
    }

    @Test
    void aReloadThatHasToWaitSaysWhyAtOnce() throws Exception {
        String wiring =
                WIRING.replace("answer: {within: 20 s}", "answer: {within: 200 ms}\n  state: {is off: \"Off\"}");
        try (LineDevice lamp = new LineDevice(line -> "")) {
            CompletableFuture<Integer> status = console.run(write(wiring + BEHAVIOUR, lamp), "--start");
            console.awaitStatus("link        up");
            lamp.tell("button power");
            console.awaitStatus("in doubt    ");

            console.type("reload");
            await().until(() -> console.printed().contains("; waiting for up to 30 s"));
            assertThat(console.printed()).contains("the device's state is in doubt: ");
            // After a line without an answer it is connected anew.
            await().ignoreExceptions().until(() -> {
                lamp.tell("is off");
                return console.printed().contains("evolved to 'new': (Off, Off) is (Off, Off)");
            });
            console.exit(status);
        }
    }

    @Test
    void aPersonSaysWhereADeviceIsThatCannotBeAsked() throws Exception {
        String wiring = WIRING.replace("answer: {within: 20 s}", "answer: {within: 200 ms}");
        try (LineDevice lamp = new LineDevice(line -> "")) {
            CompletableFuture<Integer> status = console.run(write(wiring + BEHAVIOUR, lamp), "--start");
            console.awaitStatus("link        up");
            lamp.tell("button power");
            console.awaitStatus("in doubt    ");
            console.type("found Onn");
            awaitComplaint("there is no 'Onn' here; did you mean On?");
            console.type("found On");
            console.awaitHistory("found On  (Off, Off) -> (On, On)");
            console.exit(status);
        }
    }

    @Test
    void withoutModelsNothingIsDrift() throws Exception {
        String wiring = WIRING.replace("answer: {within: 20 s}", "state: {is on: \"On\", is off: \"Off\"}");
        try (LineDevice lamp = new LineDevice(line -> line.equals("PWR") ? "is on" : "is off")) {
            CompletableFuture<Integer> status = console.run(write(wiring, lamp), "--start");
            console.awaitHistory("(Off, Off)");
            lamp.tell("button power");
            console.awaitHistory("(On, On)");
            console.type("status --json");
            await().until(() -> console.printed().contains("\"drift\":{"));
            assertThat(console.printed()).contains("\"unexplained\":0");
            console.exit(status);
        }
    }

    @Test
    void aPlayedDeviceKeepsItsModel() throws Exception {
        try (LineDevice lamp = new LineDevice(line -> "")) {
            CompletableFuture<Integer> status = console.run(write(WIRING + BEHAVIOUR, lamp), "--simulate", "--start");
            console.awaitStatus("lamp, running");
            Files.writeString(
                    folder.resolve("lamp.md"),
                    MODELS.replace("On --> Off : power", "On --> Off : power\n    On --> On : power [dim]"));
            console.type("reload");
            awaitComplaint("the original model has changed, by which --simulate plays the device");
            console.exit(status);
        }
    }
}
