package org.evoloop.device;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.CompletableFuture;
import org.evoloop.config.Options;
import org.evoloop.device.file.DeviceFileException;
import org.evoloop.mqtt.Mosquitto;
import org.evoloop.mqtt.Watcher;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.api.io.TempDir;

/** A heater behind a real broker, whose device file has 14 lines. */
@EnabledOnOs(OS.LINUX)
@Timeout(60)
class DeviceOverMqttTest {
    private static final String MODELS = """
            ## original

            ```mermaid
            stateDiagram-v2
                [*] --> Off
                Off --> Warm : power
                Warm --> Off : power
                Warm --> Hot : level
                Hot --> Warm : level
                Hot --> Off : power
            ```

            ## new

            ```mermaid
            stateDiagram-v2
                [*] --> Off
                Off --> Warm : power
                Warm --> Off : power
                Warm --> Hot : level
                Hot --> Warm : level
                Hot --> Off : power
                Off --> Quick : quick
                Warm --> Quick : quick
                Quick : «device Hot»
                Quick --> Warm : quick
                Quick --> Off : power
            ```
            """;

    private static final String HEATER = """
            converter: heater
            models: {original: heater.md#original, new: heater.md#new}
            connections:
              broker: {mqtt: "BROKER", command-topic: heater/set, state-topic: heater}
            device:
              send: {power: '{"press":"power"}', level: {payload: '{"press":"level"}'}}
              state: {json: /mode, values: {off: "Off", warm: Warm, hot: Hot}}
              confirmed: {within: 1 s}
              ask: {topic: heater/get, payload: "", within: 20 s}
              readings: {temperature: {topic: heater, json: /celsius, unit: °C}}
            controller:
              press: {topic: remote, json: /action, values: {single: power, hold: quick}}
            """;

    @RegisterExtension
    private final TypedConsole console = new TypedConsole();

    @TempDir
    private Path folder;

    @BeforeEach
    void draw() throws IOException {
        Files.writeString(folder.resolve("heater.md"), MODELS);
    }

    @Test
    void stepsAreConfirmedByTheStateAndAreAskedForIfTheyAreNot() throws Exception {
        try (Mosquitto broker = new Mosquitto(folder).start();
                Watcher watcher = new Watcher(broker)) {
            watcher.publish("heater", "{\"mode\":\"warm\",\"celsius\":40}", true);
            Path file = Files.writeString(folder.resolve("heater.yaml"), HEATER.replace("BROKER", broker.url()));
            CompletableFuture<Integer> status = console.run(file, "--start");
            console.awaitHistory("-> (Warm, Warm)");

            watcher.publish("remote", "{\"action\":\"hold\"}", false);
            watcher.awaitHeard("heater/set", "level");
            watcher.publish("heater", "{\"mode\":\"hot\",\"celsius\":90}", true);
            console.awaitHistory("quick (controller)  (Warm, Warm) -> (Hot, Quick)");

            // The command is lost; the answer to the question says so.
            watcher.publish("remote", "{\"action\":\"single\"}", false);
            watcher.awaitHeard("heater/get", "");
            watcher.publish("heater", "{\"mode\":\"hot\",\"celsius\":91}", true);
            console.awaitHistory("power (controller)");
            assertThat(watcher.heard().stream().filter(line -> line.contains("\"press\":\"power\"")))
                    .hasSize(1);
            console.awaitStatus("temperature 91");
            console.exit(status);
        }
    }

    @Test
    void aStateToWhichOneEventOfTheDevicesOwnLeadsIsThatEvent() throws Exception {
        try (Mosquitto broker = new Mosquitto(folder).start();
                Watcher watcher = new Watcher(broker)) {
            Files.writeString(
                    folder.resolve("heater.md"),
                    MODELS.replace(
                            "    Warm --> Off : power\n",
                            "    Warm --> Off : power\n    Hot --> Warm : «spontaneous» cools\n"));
            Path file = Files.writeString(
                    folder.resolve("heater.yaml"),
                    HEATER.replace("BROKER", broker.url()).replace("hot: Hot}}", "hot: Hot}, infer-events: true}"));
            watcher.publish("heater", "{\"mode\":\"hot\"}", true);
            CompletableFuture<Integer> status = console.run(file, "--start");
            console.awaitHistory("-> (Hot, Hot)");

            watcher.publish("heater", "{\"mode\":\"warm\"}", true);
            console.awaitHistory("cools (device, the device acted)  (Hot, Hot) -> (Warm, Warm)");
            // Nothing of its own leads there, so it has been found there.
            watcher.publish("heater", "{\"mode\":\"off\"}", true);
            console.awaitHistory("(Warm, Warm) -> (Off, Off)");
            console.exit(status);
        }
    }

    @Test
    void eachOfTheRulesOnATopicConfirmsAndWhatMustBeSteadyDoesSoWhenItIs() throws Exception {
        String rules =
                "[{json: /mode, values: {off: \"Off\"}}, {json: /watt, ranges: {Warm: 100..500, Hot: 500..}, steady: 50 ms}]";
        try (Mosquitto broker = new Mosquitto(folder).start();
                Watcher watcher = new Watcher(broker)) {
            Path file = Files.writeString(
                    folder.resolve("heater.yaml"),
                    HEATER.replace("BROKER", broker.url())
                            .replace("{json: /mode, values: {off: \"Off\", warm: Warm, hot: Hot}}", rules)
                            .replace("within: 1 s", "within: 20 s"));
            watcher.publish("heater", "{\"mode\":\"on\",\"watt\":200}", true);
            CompletableFuture<Integer> status = console.run(file, "--start");
            console.awaitHistory("-> (Warm, Warm)");

            watcher.publish("remote", "{\"action\":\"single\"}", false);
            watcher.awaitHeard("heater/set", "power");
            watcher.publish("heater", "{\"mode\":\"off\",\"watt\":0}", false);
            console.awaitHistory("power (controller)  (Warm, Warm) -> (Off, Off)");

            watcher.publish("remote", "{\"action\":\"single\"}", false);
            await().until(() -> watcher.heard().stream()
                            .filter(line -> line.contains("power"))
                            .count()
                    == 2);
            watcher.publish("heater", "{\"mode\":\"on\",\"watt\":900}", false);
            watcher.publish("heater", "{\"mode\":\"on\",\"watt\":200}", false);
            console.awaitHistory("power (controller)  (Off, Off) -> (Warm, Warm)");
            console.exit(status);
        }
    }

    @Test
    void whatAConnectionCannotBeAskedIsAMistakeInItsLine() throws IOException {
        String wrong = HEATER.replace("BROKER", "http://x")
                .replace("heater/set", "heater/#")
                .replace("json: /mode", "json: mode")
                .replace("json: /action, values: {single: power, hold: quick}", "pattern: '['");
        Path file = Files.writeString(folder.resolve("heater.yaml"), wrong);
        DeviceFileException refused = null;
        try {
            DeviceFile.read(file, Options.of());
        } catch (DeviceFileException problem) {
            refused = problem;
        }
        assertThat(refused).isNotNull();
        assertThat(String.valueOf(refused == null ? "" : refused.getMessage())
                        .replace(folder + "/", "")
                        .lines())
                .anySatisfy(line -> assertThat(line).startsWith("heater.yaml:4: mqtt: "))
                .anySatisfy(line -> assertThat(line).startsWith("heater.yaml:4: command-topic: 'heater/#' is no topic"))
                .anySatisfy(line -> assertThat(line).startsWith("heater.yaml:7: json: "))
                .anySatisfy(
                        line -> assertThat(line).startsWith("heater.yaml:12: pattern: '[' is no regular expression"))
                .anySatisfy(line -> assertThat(line).startsWith("heater.yaml:12: controller.press needs event"));
    }
}
