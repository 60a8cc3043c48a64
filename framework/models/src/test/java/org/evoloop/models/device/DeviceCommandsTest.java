package org.evoloop.models.device;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The commands for device files, with their exit statuses. */
class DeviceCommandsTest {
    private final PrintStream out = System.out;
    private final PrintStream err = System.err;
    private final ByteArrayOutputStream printed = new ByteArrayOutputStream();
    private final ByteArrayOutputStream errors = new ByteArrayOutputStream();
    private final List<List<String>> models = new ArrayList<>();

    @TempDir
    private Path folder;

    @BeforeEach
    void redirect() {
        System.setOut(new PrintStream(printed, true, StandardCharsets.UTF_8));
        System.setErr(new PrintStream(errors, true, StandardCharsets.UTF_8));
        System.setProperty("evoloop.home", System.getProperty("evoloop.root", "../.."));
    }

    @AfterEach
    void restore() {
        System.setOut(out);
        System.setErr(err);
        System.clearProperty("evoloop.home");
    }

    private int run(String... arguments) {
        return DeviceCommands.run(List.of(arguments), command -> {
            models.add(command);
            return 0;
        });
    }

    private String printed() {
        return printed.toString(StandardCharsets.UTF_8);
    }

    private String errors() {
        return errors.toString(StandardCharsets.UTF_8);
    }

    @ParameterizedTest
    @ValueSource(strings = {"lines", "mqtt", "http"})
    void whatNewWritesPassesItsCheck(String connection) throws IOException {
        Path heater = folder.resolve("heater");
        assertThat(run("new", heater.toString(), "--connection=" + connection, "--events=power,mode"))
                .as(errors())
                .isZero();
        assertThat(printed()).contains("wrote " + heater.resolve("heater.yaml"));
        assertThat(run("check", heater.resolve("heater.yaml").toString()))
                .as(errors())
                .isZero();
        assertThat(printed()).contains("passed: after ten minutes it is switched off");
        assertThat(models).containsExactly(List.of("check", heater + "/README.md#original", heater + "/README.md#new"));
        assertThat(run("new", heater.toString())).isEqualTo(2);
        assertThat(errors()).contains("exists already; give another name");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "air-conditioner",
                "fan",
                "home-assistant-lamp",
                "light-bulb",
                "octoprint",
                "roller-shutter",
                "time-clock",
                "valetudo",
                "washing-machine",
                "wifi-roomba",
                "zigbee-bulb"
            })
    void aCopiedDevicePassesItsCheckUnderItsNewName(String device) throws IOException {
        Path mine = folder.resolve("mine");
        assertThat(run("new", mine.toString(), "--from", device)).as(errors()).isZero();
        assertThat(mine.resolve("README.md")).isRegularFile();
        assertThat(mine.resolve("mine.yaml"))
                .content()
                .contains("converter: mine\n")
                .doesNotContain("devices/" + device);
        assertThat(run("check", mine.resolve("mine.yaml").toString()))
                .as(errors() + printed())
                .isZero();
        assertThat(printed()).contains("passed: ").doesNotContain("FAILED");
    }

    @Test
    void theLinksOfACopiedDeviceStillLeadWhereTheyLed() throws IOException {
        Path mine = folder.resolve("mine");
        run("new", mine.toString(), "--from", "air-conditioner");
        Matcher link = Pattern.compile("\\((\\.\\./[^)]*)\\)").matcher(Files.readString(mine.resolve("README.md")));
        assertThat(link.find()).isTrue();
        assertThat(mine.resolve(link.group(1))).isRegularFile();
    }

    @Test
    void onlyADeviceThatIsThereCanBeCopiedAndNothingIsAskedOfIt() {
        String mine = folder.resolve("mine").toString();
        assertThat(run("new", mine, "--from", "zigbee-bull")).isEqualTo(2);
        assertThat(errors()).contains("there is no device 'zigbee-bull'; did you mean zigbee-bulb?");
        assertThat(run("new", mine, "--from", "fan", "--connection", "mqtt")).isEqualTo(2);
        assertThat(errors()).contains("leave --connection, --address and --events out");
        assertThat(folder.resolve("mine")).doesNotExist();
    }

    @Test
    void aScenarioThatFailsIsAFailedCheckWithItsLine() throws IOException {
        Path heater = folder.resolve("heater");
        run("new", heater.toString());
        Path file = heater.resolve("heater.yaml");
        Files.writeString(file, Files.readString(file).replace("after: 10 min", "after: 9 min"));
        assertThat(run("check", file.toString())).isEqualTo(1);
        assertThat(printed())
                .contains("FAILED: after ten minutes it is switched off")
                .containsPattern("at: +" + file + ":[0-9]+: sent is \\[\\], expected is \\[power\\]");
    }

    @Test
    void theFrontPageShowsTheLightBulbsFileAndModels() throws IOException {
        Path root = Path.of(System.getProperty("evoloop.home"));
        String page = Files.readString(root.resolve("README.md"));
        Matcher block = Pattern.compile("```yaml\\n(.*?)```", Pattern.DOTALL).matcher(page);
        assertThat(block.find()).isTrue();
        assertThat(root.resolve("devices/light-bulb/light-bulb.yaml")).content().contains(block.group(1));
        Files.writeString(folder.resolve("README.md"), page);
        Path file = Files.writeString(folder.resolve("lamp.yaml"), block.group(1));
        assertThat(run("check", file.toString())).as(errors() + printed()).isZero();
        assertThat(printed()).contains("passed: switched twice").doesNotContain("FAILED");
    }

    @Test
    void itsPropertiesAreCheckedWithTheModels() throws IOException {
        Path heater = folder.resolve("heater");
        run("new", heater.toString());
        Path file = heater.resolve("heater.yaml");
        Path properties = Files.writeString(heater.resolve("wanted.txt"), "always On or Off\n");
        Files.writeString(
                file, Files.readString(file).replace("README.md#new}", "README.md#new, properties: wanted.txt}"));
        run("check", file.toString());
        assertThat(models.get(models.size() - 1)).containsSequence("--properties", properties.toString());
    }

    @Test
    void whatCannotBeBuiltIsAFailedCheck() throws IOException {
        Path heater = folder.resolve("heater");
        run("new", heater.toString());
        Path readme = heater.resolve("README.md");
        Files.writeString(
                readme,
                Files.readString(readme).replace("    Timed --> Off : power\n", "    Timed --> Off : power [hot]\n"));
        assertThat(run("check", heater.resolve("heater.yaml").toString())).isEqualTo(1);
        assertThat(printed()).contains("guard [hot] of the new model is not bound");
        assertThat(models).as("the models are checked, too").hasSize(1);
    }

    @Test
    void aFileWithoutModelsIsSaidToHaveNothingElseToCheck() throws IOException {
        Path file = Files.writeString(
                folder.resolve("x.yaml"),
                "converter: x\nconnections: {x: {lines: \"tcp://localhost:1\"}}\ndevice: {send: {power: PWR}}\n");
        assertThat(run("check", file.toString())).as(errors()).isZero();
        assertThat(printed()).isEqualTo("the wiring is right; there are neither models nor scenarios to check\n");
    }

    @Test
    void everyMistakeInAFileIsALine() throws IOException {
        Path file = Files.writeString(folder.resolve("x.yaml"), "convertr: x\nconnections: {a: {lnes: b}}\n");
        assertThat(run("check", file.toString())).isEqualTo(2);
        assertThat(errors().lines())
                .allMatch(line -> line.startsWith("error: " + file + ":"))
                .hasSize(3);
        assertThat(run("run", file.toString())).isEqualTo(2);
        assertThat(run("run", folder.resolve("no.yaml").toString())).isEqualTo(2);
        assertThat(errors()).contains("no.yaml: does not exist; correct the path");
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "run", "check", "check --x", "check a b", "nonsense"})
    void wrongUsageIsAnsweredByTheUsage(String line) {
        assertThat(run(line.isEmpty() ? new String[0] : line.split(" "))).isEqualTo(2);
        assertThat(errors()).startsWith("usage: evoloop run FILE.yaml");
    }

    @Test
    void helpIsPrinted() {
        assertThat(run("check", "--help")).isZero();
        assertThat(run("run", "--help")).isZero();
        assertThat(printed())
                .contains("usage: evoloop run FILE.yaml")
                .contains("Usage: evoloop run FILE.yaml [")
                .contains("--simulate");
    }

    @ParameterizedTest
    @ValueSource(strings = {"--connection=foo", "--events=a-b", "--events="})
    void whatNewCannotUseIsRefusedAndNothingIsWritten(String option) {
        Path heater = folder.resolve("heater");
        assertThat(run("new", heater.toString(), option)).isEqualTo(2);
        assertThat(heater).doesNotExist();
    }

    /** A garage door with one button, which stops it, and then turns it round. */
    private Path garage(String entity) throws IOException {
        Files.writeString(folder.resolve("models.md"), """
            ```mermaid
            ---
            title: door
            ---
            stateDiagram-v2
                [*] --> Closed
                Closed --> Opening : button
                Opening --> Stopped : button
                Opening --> Open : «spontaneous» opened
                Stopped --> Closing : button
                Open --> Closing : button
                Closing --> Between : button
                Closing --> Closed : «spontaneous» closed
                Between --> Opening : button
            ```
            """);
        return Files.writeString(folder.resolve("garage.yaml"), """
            converter: garage
            models: {original: models.md#door, new: models.md#door}
            connections: {door: {lines: "tcp://127.0.0.1:1"}}
            device: {send: {button: B}, does: {o: opened, c: closed}}
            home-assistant:
              cover: %s
            """.formatted(entity));
    }

    @Test
    void aCommandOfAnEntityThatWouldDoSomethingElseIsAFindingOnItsLine() throws Exception {
        assertThat(run("check", garage("{}").toString())).isEqualTo(1);
        assertThat(printed())
                .contains(
                        "cover in Home Assistant:",
                        "presses button, to Closing",
                        "garage.yaml:6: cover, close in Between")
                .contains("since it could lead through Opening, which is shown as opening");
        printed.reset();
        assertThat(run(
                        "check",
                        garage("{never-in: {Between: [close], Stopped: [open]}}")
                                .toString()))
                .isZero();
        assertThat(printed()).contains("refused, never in Between").doesNotContain("finding:");
    }

    @Test
    void aCommandThatEndsInTheContraryIsAMistake() throws Exception {
        assertThat(run("check", garage("{commands: {close: Open}}").toString())).isEqualTo(2);
        assertThat(errors()).contains("garage.yaml:6: 'close' of a cover would end in 'Open', which is shown as open");
        assertThat(run(
                        "check",
                        garage("{states: {Opn: open}, modes: {a: Open}, nme: x}")
                                .toString()))
                .isEqualTo(2);
        assertThat(errors())
                .contains("'Opn' is not a state of the new model", "a cover has no modes", "'nme' is not known");
    }
}
