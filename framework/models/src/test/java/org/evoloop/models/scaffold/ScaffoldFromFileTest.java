package org.evoloop.models.scaffold;

import static org.assertj.core.api.Assertions.assertThat;
import static org.evoloop.models.scaffold.ScaffoldTest.JAVA_PACKAGE;

import java.io.BufferedReader;
import java.io.File;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.stream.Stream;
import org.evoloop.models.Tool;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** A device file becomes a Java project, which does what the file says, and does not need it any more. */
class ScaffoldFromFileTest {
    private static final Path DEVICES = Path.of("../../devices");
    private static final String MODELS = """
            # A lamp

            ```mermaid
            ---
            title: original
            ---
            stateDiagram-v2
                [*] --> Off
                Off --> On : switch
                On --> Off : switch
                On --> Off : burns out
            ```

            ```mermaid
            ---
            title: new
            ---
            stateDiagram-v2
                [*] --> Off
                Off --> On : switch [evening] / chime
                On --> Off : switch
                On --> Off : burns out
                On --> Party : party
                Off --> Party : party [warm]
                Party --> On : over
                Party --> Off : switch
                Party --> Off : burns out
            ```
            """;
    private static final String LAMP = """
            converter: lamp
            models: {original: lamp.md#original, new: lamp.md#new}
            connections:
              lamp:
                http: "http://127.0.0.1:9"
                headers: {X-Key: "a \\"b\\""}
                header-files: {X-Secret: key.txt}
                poll: /state
                every: 500 ms
              remote: {lines: "serial:///dev/ttyUSB0", baud: 19200}
              panel: {program: [cat], greet: HELLO}
              home: {mqtt: "mqtt://127.0.0.1"}
            device:
              send: {switch: {to: lamp, call: POST /switch, body: '{"by": 1}', accepted: 200..204, cost: 2}}
              state: {from: lamp, json: /on, values: {"true": "On", "false": "Off"}, infer-events: true}
              does: {from: home, topic: lamp/events, pattern: "burn(ing|t).*", event: burns out}
              readings:
                room: {from: home, topic: lamp/room, json: /t, unit: °C}
                light: {from: panel, line: "LIGHT ([0-9]+)"}
              ready-after: 100 ms
            controller:
              press:
                - {from: remote, values: {one: switch}}
                - {from: remote, line: "party (?<beats>[0-9]+)", event: party}
                - {from: home, topic: lamp/power, ranges: {party: 100..}, steady: 2 s}
            functions:
              Party:
                on-enter: [{to: panel, line: LED ON}, {say: it begins}]
                steps:
                  - send: switch
                  - wait: 90 s
                  - {to: home, topic: lamp/say, payload: soon over}
                  - {to: lamp, call: GET /ping}
                  - wait: 30 s
                  - finish: over
                every: 50 s
                send: switch
                at: [{time: "23:30", finish: over}]
                on-exit: {to: panel, line: LED OFF}
            guards:
              evening: {between: ["18:00", "23:00"]}
              warm: {reading: room, above: 20}
            effects:
              chime: {run: [aplay, chime.wav], within: 3 s}
            scenarios:
              only in the evening:
                - {until: "12:00", press: switch, sent: [], state: "Off"}
                - {until: "18:30", press: switch, sent: [switch], state: "On"}
              a party: [{readings: {room: 21.5}, press: party, state: Party, sent: [switch]}, {after: 119 s, state: Party, sent: [switch, switch]}, {after: 2 s, state: "On"}]
            """;

    @TempDir
    private Path directory;

    private Tool scaffold(Path file) {
        return Tool.run(
                "scaffold",
                "--from",
                file.toString(),
                "--package",
                JAVA_PACKAGE,
                "--out",
                directory.resolve("project").toString());
    }

    private Path project(Path file) {
        Tool run = scaffold(file);
        assertThat(run.err()).isEmpty();
        assertThat(run.status()).isZero();
        return directory.resolve("project");
    }

    private Path lamp(String text) throws IOException {
        Files.writeString(directory.resolve("lamp.md"), MODELS);
        Files.writeString(directory.resolve("key.txt"), "secret");
        return Files.writeString(directory.resolve("lamp.yaml"), text);
    }

    @ParameterizedTest
    @CsvSource({
        "fan, 4",
        "zigbee-bulb, 4",
        "valetudo, 3",
        "washing-machine, 4",
        "wifi-roomba, 4",
        "air-conditioner, 3",
        "octoprint, 3",
        "home-assistant-lamp, 4"
    })
    void aDevicesScenariosPassInJava(String device, int tests) throws Exception {
        Path project = project(DEVICES.resolve(device).resolve(device + ".yaml"));

        ScaffoldTest.assertAllPassed(ScaffoldTest.run(ScaffoldTest.compile(project), "ScenariosTest"), tests);
    }

    @Test
    void whateverAFileMaySayCompilesAndPasses() throws Exception {
        Path project = project(lamp(LAMP));

        ScaffoldTest.assertAllPassed(ScaffoldTest.run(ScaffoldTest.compile(project), "ScenariosTest"), 3);
        assertThat(project.resolve("pom.xml"))
                .content()
                .contains("evoloop-line<", "evoloop-serial<", "evoloop-http<", "evoloop-mqtt<", "evoloop-testkit<")
                .doesNotContain("evoloop-device<");
    }

    @Test
    void pinsAndWebhooksAndFunctionsElsewhereCompileAndPass() throws Exception {
        String file = """
                converter: lamp
                models: {original: lamp.md#original, new: lamp.md#new}
                connections:
                  pins: {gpio: true, debounce: 30 ms}
                  phone: {webhooks: 8123}
                  party: {program: [python3, party.py]}
                  home: {mqtt: "mqtt://127.0.0.1"}
                device:
                  send: {switch: {to: pins, pulse: 23, for: 300 ms}}
                  state: {from: pins, contact: 17, closed: "On", open: "Off"}
                  does: {from: phone, values: {POST /burnt: burns out}}
                controller:
                  press:
                    - {from: pins, contact: 27, event: switch, debounce: 50 ms}
                    - {from: phone, values: {POST /party: party}}
                functions:
                  Party: {elsewhere: PARTY, sends: [switch], raises: [over]}
                guards: {evening: {between: ["00:00", "23:59"]}, warm: {value: t, below: 3}}
                effects: {chime: {to: pins, hold: 24, level: high}}
                scenarios:
                  a party: [{press: switch, sent: [switch], state: "On"}, {press: party, state: Party}, {press: switch, state: "Off"}]
                """;
        for (String party : List.of("party", "home")) {
            Path project = project(lamp(file.replace("PARTY", party)));

            ScaffoldTest.assertAllPassed(ScaffoldTest.run(ScaffoldTest.compile(project), "ScenariosTest"), 2);
            assertThat(project.resolve("pom.xml"))
                    .content()
                    .contains("evoloop-gpio<", "evoloop-http<", "evoloop-line<", "evoloop-payload<");
            Files.move(project, directory.resolve("project with " + party));
        }
    }

    @Test
    void entitiesOfHomeAssistantCompileAndPass() throws Exception {
        Files.writeString(directory.resolve("token"), "secret");
        Path project = project(lamp("""
                converter: lamp
                models: {original: lamp.md#original, new: lamp.md#new}
                connections:
                  home: {home-assistant: "http://127.0.0.1:8123", token-file: token, entity: light.lamp}
                  house: {home-assistant: "https://127.0.0.1?sha256=FINGERPRINT"}
                device:
                  send: {switch: {to: home, service: light.toggle, data: {transition: 0.5, effect: "1", flash: "${flash}"}}}
                  state:
                    - {from: home, values: {"off": "Off"}}
                    - {from: home, attribute: brightness, ranges: {On: 1..}, infer-events: true}
                  does: {from: home, entity: event.lamp, attribute: event_type, values: {burnt: burns out}}
                  readings: {power: {from: house, entity: sensor.power, unit: W}}
                  confirmed: {within: 3 s}
                  ask: {within: 4 s}
                  ready-after: 100 ms
                controller:
                  press:
                    - {from: home, entity: input_button.lamp, event: switch}
                    - {from: house, event-type: zha_event, json: /command, values: {hold: party}}
                    - {from: house, trigger: {trigger: state, entity_id: [sun.sun]}, event: party}
                functions:
                  Party: {steps: [{to: house, service: notify.notify, data: {message: it begins}}, {finish: over}]}
                guards: {evening: {between: ["00:00", "23:59"]}, warm: {value: t, below: 3}}
                effects: {chime: {to: house, service: script.chime}}
                scenarios:
                  it is lit: [{press: switch, sent: [switch], state: "On"}]
                """.replace("FINGERPRINT", "AB".repeat(32))));

        ScaffoldTest.assertAllPassed(ScaffoldTest.run(ScaffoldTest.compile(project), "ScenariosTest"), 2);
        assertThat(project.resolve("pom.xml")).content().contains("evoloop-home-assistant<");
        assertThat(project.resolve("src/main/java/" + JAVA_PACKAGE.replace('.', '/') + "/Connections.java"))
                .content()
                .contains(
                        "Secret.read(Path.of(\"" + directory.resolve("token"),
                        "EVOLOOP_HOME_ASSISTANT_TOKEN",
                        "{\\\"transition\\\":0.5,\\\"effect\\\":\\\"1\\\",\\\"flash\\\":\\\"${flash}\\\"}",
                        ".require(new ServiceCall(\"script.chime\", null, \"{}\"))");
    }

    /** The program takes a press from the device's remote control, sends two lines, and waits for the answer to each. */
    @Test
    void theFansProgramTalksToAFan() throws Exception {
        try (ServerSocket listening = new ServerSocket(0, 1, InetAddress.getByName("127.0.0.1"))) {
            Path fan = DEVICES.resolve("fan");
            Files.copy(fan.resolve("README.md"), directory.resolve("README.md"));
            Path file = Files.writeString(
                    directory.resolve("fan.yaml"),
                    Files.readString(fan.resolve("fan.yaml"))
                            .replace("127.0.0.1:4001", "127.0.0.1:" + listening.getLocalPort()));
            Path classes = ScaffoldTest.compile(project(file));
            Files.delete(file);
            listening.setSoTimeout(60_000);
            Process program = new ProcessBuilder(
                            Path.of(System.getProperty("java.home"), "bin", "java")
                                    .toString(),
                            "-cp",
                            classes + File.pathSeparator + System.getProperty("java.class.path"),
                            JAVA_PACKAGE + ".Main",
                            "--start")
                    .directory(directory.toFile())
                    .redirectErrorStream(true)
                    .start();
            try (Socket wire = listening.accept();
                    BufferedReader told = program.inputReader()) {
                wire.setSoTimeout(60_000);
                BufferedReader lines =
                        new BufferedReader(new InputStreamReader(wire.getInputStream(), StandardCharsets.UTF_8));
                OutputStream out = wire.getOutputStream();
                assertThat(lines.readLine()).isEqualTo("STATE?");
                tell(out, "is Off");
                awaitRunning(program, told);
                tell(out, "remote boost");
                assertThat(lines.readLine()).isEqualTo("PWR");
                tell(out, "OK");
                assertThat(lines.readLine()).isEqualTo("SPD");
            } finally {
                program.destroyForcibly();
            }
        }
    }

    /** What is pressed before the converter runs is lost. */
    private static void awaitRunning(Process program, BufferedReader told) throws IOException {
        String line = "";
        while (!line.matches("converter +fan, running")) {
            if (line.isEmpty() || line.startsWith("converter")) {
                tell(program.getOutputStream(), "status");
            }
            line = Objects.requireNonNull(told.readLine(), "the program has ended");
        }
    }

    private static void tell(OutputStream out, String line) throws IOException {
        out.write((line + "\n").getBytes(StandardCharsets.UTF_8));
        out.flush();
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "functions: {Party: {}}\\npage: 8080|:6: 'page' is an option",
                "functions: {Party: {}}\\nschedule: {switch: '09:00'}|:6: 'schedule' is not written in Java; leave it out",
                "functions: {Party: {}}\\nconverter: again|:6: 'converter' is given twice",
            })
    void whatCannotBecomeJavaIsRefusedWithItsLine(String more, String message) throws IOException {
        Path file = lamp("""
                converter: lamp
                models: {original: lamp.md#original, new: lamp.md#new}
                connections: {lamp: {lines: "tcp://127.0.0.1:1"}}
                device: {send: {switch: SW}, does: {BURNT: burns out}}
                """
                + more.replace("\\n", "\n")
                + "\nguards: {evening: {between: [\"18:00\", \"23:00\"]}, warm: {value: t, below: 3}}"
                + "\neffects: {chime: {line: DING}}\n");

        Tool run = scaffold(file);

        assertThat(run.err()).startsWith("error: " + file + message).hasLineCount(1);
        assertThat(run.status()).isEqualTo(2);
        assertThat(directory.resolve("project")).doesNotExist();
    }

    @Test
    void aFileWithoutModelsIsRefused() throws IOException {
        Tool run = scaffold(lamp("converter: lamp\nconnections: {pins: {gpio: true}}\n"));

        assertThat(run.err()).contains(":1: a project needs models").hasLineCount(1);
        assertThat(run.status()).isEqualTo(2);
    }

    @Test
    void whatTheFileSaysIsNoOption() {
        Tool run = Tool.run("scaffold", "--from", "a.yaml", "--package", "a.b", "--out", "out", "--spontaneous", "x");

        assertThat(run.err()).contains("--spontaneous does not go with --from");
        assertThat(run.status()).isEqualTo(2);
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "lamp.md#original", "lamp.md#original lamp.md#new --from lamp.yaml"})
    void eitherModelsOrAFileAreGiven(String arguments) {
        List<String> words = arguments.isEmpty() ? List.of() : List.of(arguments.split(" "));
        Tool run = Tool.run(Stream.concat(Stream.of("scaffold", "--package", "a.b", "--out", "out"), words.stream())
                .toArray(String[]::new));

        assertThat(run.err()).contains("give either ORIGINAL and NEW, or a device file with --from FILE.yaml");
        assertThat(run.status()).isEqualTo(2);
    }
}
