package org.evoloop.device;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.InstanceOfAssertFactories.STRING;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.evoloop.config.Settings;
import org.evoloop.device.file.DeviceFileException;
import org.evoloop.page.PageOptions;
import org.evoloop.service.ServiceOptions;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Reading a device file, with all its mistakes. */
class DeviceFileTest {
    private static final String FAN = """
            converter: fan
            models: {original: fan.md#original, new: fan.md#new}
            connections:
              fan: {lines: 'tcp://127.0.0.1:4001', greet: STATE?, watch: {after: 10 s, ask: STATE?}}
            device:
              send: {power: PWR, speed: SPD}
              answer: {ok: OK, error: ERR.*, within: 2 s}
              ask: {line: STATE?}
              state: {is off: 'Off', is low: Low, is high: High}
              does: {overheated: overheat}
              readings:
                temperature: {line: 'T ([0-9]+)', unit: °C}
            controller:
              press: {button power: power, button speed: speed, button breeze: breeze}
            functions:
              Breeze: {every: 3 s, send: speed}
            scenarios:
              a breeze changes the speed until it is stopped:
                - {press: power, sent: [power], state: Low}
                - {press: breeze, state: Breeze}
                - {after: 7 s, sent: [speed, speed], device-state: Low}
                - {press: power, sent: [power], state: 'Off'}
              it may overheat:
                - {press: power}
                - {press: speed, state: High}
                - {device: overheat, state: 'Off'}
            """;

    private static final String MODELS = """
            ## original

            ```mermaid
            stateDiagram-v2
                [*] --> Off
                Off --> Low : power
                Low --> Off : power
                Low --> High : speed
                High --> Low : speed
                High --> Off : power
                High --> Off : «spontaneous» overheat
            ```

            ## new

            ```mermaid
            stateDiagram-v2
                [*] --> Off
                Off --> Low : power
                Low --> Off : power
                Low --> High : speed
                High --> Low : speed
                High --> Off : power
                High --> Off : overheat
                Low --> Breeze : breeze
                Breeze --> Off : power
                Breeze --> Off : overheat
            ```
            """;

    @TempDir
    private Path folder;

    @BeforeEach
    void draw() throws IOException {
        Files.writeString(folder.resolve("fan.md"), MODELS);
    }

    private DeviceFile read(String text) throws IOException {
        return DeviceFile.read(Files.writeString(folder.resolve("fan.yaml"), text), DeviceProgram.options());
    }

    private List<String> mistakes(String text) {
        List<String> lines = new ArrayList<>();
        assertThatThrownBy(() -> read(text))
                .isInstanceOf(DeviceFileException.class)
                .satisfies(refused -> lines.addAll(
                        refused.getMessage().replace(folder + "/", "").lines().toList()));
        return lines;
    }

    @Test
    void aFileIsAConverterWhoseScenariosPass() throws IOException {
        DeviceFile fan = read(FAN);
        assertThat(fan.name()).isEqualTo("fan");
        assertThat(fan.connections()).extracting(Connection::name).containsExactly("fan", "run");
        assertThat(fan.scenarios()).extracting(scenario -> scenario.run(fan)).containsExactly("", "");
    }

    @Test
    void aScenarioThatFailsSaysWhereAndWhy() throws IOException {
        DeviceFile fan =
                read(FAN.replace("sent: [speed, speed], device-state: Low", "sent: [speed], device-state: High"));
        assertThat(fan.scenarios().get(0).run(fan)).isEqualTo("21: sent is [speed, speed], expected is [speed]");
    }

    @Test
    void theProgramsOptionsMayStandInItAndTheirPathsAreRelativeToIt() throws IOException {
        DeviceFile fan = read(FAN + "journal: kept\npage: 8080\nstart: true\n");
        Settings settings = DeviceProgram.options().read(List.of("--page=9090"), fan.options(), Map.of());
        ServiceOptions service = ServiceOptions.of(settings);
        assertThat(service.journal()).isEqualTo(folder.resolve("kept"));
        assertThat(service.start()).isTrue();
        assertThat(PageOptions.of(settings).port()).isEqualTo(9090);
    }

    @Test
    void onlyAConnectionThatReportsCanConfirmWhatIsSentOverOthers() {
        String confirmed = FAN.replace("device:\n", "device:\n  confirmed: {from: fan}\n");
        int line = FAN.substring(0, FAN.indexOf("device:")).split("\n").length + 2;
        assertThat(mistakes(confirmed))
                .containsExactly(
                        "fan.yaml:" + line + ": connection fan, of the kind lines, does not tell what became of an"
                                + " event; a connection to a broker does");
        assertThat(mistakes(confirmed.replace("from: fan", "from: meter")))
                .first(STRING)
                .contains(":" + line + ": there is no connection 'meter'");
        assertThat(mistakes(confirmed.replace("from: fan", "within: 2 s")))
                .first(STRING)
                .contains("'confirmed' is not known");
        assertThat(mistakes(FAN.replace("ask: {line: STATE?}", "ask: {line: STATE?, to: meter}")))
                .first(STRING)
                .contains("there is no connection 'meter'");
    }

    @Test
    void aMistakeInAProgramsOptionHasItsLine() {
        int line = (int) FAN.lines().count();
        assertThat(mistakes(FAN + "page: many\nstart: maybe\nmqtt: [a, b]\nname: ''\njournal: {a: b}\n"
                        + "mqtt-password: secret\n"))
                .satisfiesExactly(
                        page -> assertThat(page).startsWith("fan.yaml:" + (line + 1) + ": page"),
                        start -> assertThat(start)
                                .isEqualTo("fan.yaml:" + (line + 2)
                                        + ": start: 'maybe' is neither true nor false; write one of them"),
                        mqtt -> assertThat(mqtt)
                                .isEqualTo("fan.yaml:" + (line + 3) + ": mqtt takes one value, not a list"),
                        name -> assertThat(name).startsWith("fan.yaml:" + (line + 4) + ": name"),
                        journal -> assertThat(journal).startsWith("fan.yaml:" + (line + 5) + ": journal is a mapping"),
                        password -> assertThat(password)
                                .startsWith("fan.yaml:" + (line + 6) + ": 'mqtt-password' is not known")
                                .contains("mqtt-password-file"));
    }

    @Test
    void propertiesAreReadWithTheFileAndTheirMistakesSaidBesideItsOwn() throws IOException {
        String named = FAN.replace("fan.md#new", "fan.md#new, properties: fan.properties.txt");
        assertThat(named).isNotEqualTo(FAN);
        assertThat(mistakes(named))
                .containsExactly("fan.yaml:2: there is no file fan.properties.txt of properties beside this file");

        Files.writeString(folder.resolve("fan.properties.txt"), "Calm: Breeze never longer than 5 min\n");
        DeviceFile fan = read(named);
        assertThat(fan.properties()).contains(folder.resolve("fan.properties.txt"));
        assertThat(fan.programModels().time().properties()).hasSize(1);

        Files.writeString(folder.resolve("fan.properties.txt"), "Calm: Breze never longer than 5 min\n");
        assertThat(mistakes(named + "color: red\n"))
                .anyMatch(line -> line.startsWith("fan.yaml:2: ") && line.contains("line 1") && line.contains("Breze"))
                .anyMatch(line -> line.contains("color"));
    }

    @Test
    void aScenarioSetsTheReadingsAndTheTimeOfDayThatGuardsAskFor() throws IOException {
        Files.writeString(
                folder.resolve("fan.md"),
                MODELS.replace(
                        "    Low --> Breeze",
                        "    Off --> High : cool [warm]\n    Off --> Low : air [at noon]\n    Low --> Breeze"));
        DeviceFile fan = read(FAN.replaceAll("(?s)scenarios:.*", "")
                        .replace("button breeze: breeze", "button breeze: breeze, cool: cool, air: air")
                + """
                guards:
                  warm: {reading: temperature, above: 25}
                  at noon: {between: ['12:00', '13:00']}
                scenarios:
                  it is cooled when it is warm:
                    - {press: cool, sent: []}
                    - {readings: {temperature: 25}, press: cool, sent: []}
                    - {readings: {temperature: 25.5}, press: cool, sent: [power, speed]}
                  it is aired at noon:
                    - {until: '11:59', press: air, sent: []}
                    - {until: '12:00', press: air, sent: [power]}
                  each scenario has its own readings:
                    - {press: cool, sent: []}
                """);
        assertThat(fan.scenarios()).extracting(scenario -> scenario.run(fan)).containsExactly("", "", "");
        assertThat(mistakes(FAN.replace("{after: 7 s,", "{readings: {temperature: warm}, until: noon,")))
                .containsExactly(
                        "fan.yaml:21: 'warm' is no number",
                        "fan.yaml:21: until: 'noon' is no time of day; write it as 07:30");
    }

    @Test
    void withoutModelsEachEventIsALoop() throws IOException {
        DeviceFile wired = read("""
                converter: fan
                connections: {fan: {lines: 'tcp://127.0.0.1:4001'}}
                device: {send: {power: PWR}, does: {overheated: overheat}}
                controller: {press: {button power: power}}
                scenarios:
                  passes on:
                    - {press: power, sent: [power], state: Any}
                    - {device: overheat, state: Any}
                """);
        assertThat(wired.scenarios().get(0).run(wired)).isEmpty();
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "send: {power: PWR, speed: SPD} | send: {power: PWR, spede: SPD} | fan.yaml:6: 'spede' is not an event of the original model; did you mean speed?",
                "is low: Low | is low: Lwo | fan.yaml:9: 'Lwo' is not a state of the original model; did you mean Low?",
                "greet: | gret: | fan.yaml:4: 'gret' is not known in connections.fan; did you mean greet?",
                "device: | devise: | fan.yaml:5: 'devise' is not known; did you mean device?",
                "Breeze: {every | Breze: {every | fan.yaml:16: 'Breze' is not a state of the new model; did you mean Breeze?",
                "every: 3 s | every: 3 | fan.yaml:16: every: '3' is no duration; write a number and a unit, such as 500 ms, 10 s, 5 min or 2 h",
                "lines: 'tcp://127.0.0.1:4001' | lines: '127.0.0.1:4001' | fan.yaml:4: lines: '127.0.0.1:4001' is no address; write tcp://HOST:PORT, serial:///dev/ttyUSB0 or unix:///run/device.sock",
                "lines: | lnes: | fan.yaml:4: connections.fan needs one of gpio, http, lines, mqtt, program, webhooks; did you mean lines?",
                "T ([0-9]+) | T [0-9]+ | fan.yaml:12: the pattern 'T [0-9]+' has no group; put the value in parentheses",
                "button breeze: breeze | button breeze: breze | fan.yaml:14: 'breze' is not an event of the models; did you mean breeze?",
                "fan.md#new | fan.md#now | fan.yaml:2: ",
                "send: speed} | send: sped} | fan.yaml:16: 'sped' is not an event that is sent to the device; did you mean speed?",
                "after: 7 s | aftr: 7 s | fan.yaml:21: 'aftr' is not known in scenarios.a breeze changes the speed until it is stopped; did you mean after?",
                "Breeze: {every: 3 s, send: speed} | Low: {} | fan.yaml:16: 'Low' is a state of the device, which has no function; only new states have",
            })
    void aMistakeNamesItsLineAndTheNearestName(String right, String wrong, String message) {
        assertThat(FAN).contains(right);
        assertThat(mistakes(FAN.replace(right, wrong)))
                .anySatisfy(line -> assertThat(line).startsWith(message));
    }

    @Test
    void allMistakesAreFoundAtOnce() {
        assertThat(mistakes(FAN.replace("is low: Low", "is low: Lwo")
                        .replace("greet:", "gret:")
                        .replace("every: 3 s", "every: soon")))
                .extracting(line -> line.replaceAll("(fan.yaml:\\d+): .*", "$1"))
                .containsExactly("fan.yaml:4", "fan.yaml:9", "fan.yaml:16");
    }

    @Test
    void anEventThatNothingSendsIsAMistakeAndSoIsAStateWithoutFunction() {
        assertThat(mistakes(FAN.replace(", speed: SPD", "").replace("  Breeze: {every: 3 s, send: speed}\n", "  {}\n")))
                .anySatisfy(line -> assertThat(line).contains("nothing sends 'speed', an event of the original model"))
                .anySatisfy(line -> assertThat(line).contains("new state 'Breeze' has no function"));
    }

    @Test
    void whatYamlCanDoBesidesIsRefused() {
        assertThat(mistakes(FAN.replace("send: {power", "send: &all {power")))
                .hasSize(1)
                .allSatisfy(line ->
                        assertThat(line).startsWith("fan.yaml:6: anchors (&) and aliases (*) are not supported"));
        assertThat(mistakes(FAN + "converter: fan\n"))
                .containsExactly("fan.yaml:27: 'converter' is given twice, first in line 1; keep one");
        assertThat(mistakes("- converter: fan\n")).hasSize(1);
        assertThat(mistakes("")).hasSize(1);
        assertThat(mistakes("converter: [fan\n")).hasSize(1);
    }
}
