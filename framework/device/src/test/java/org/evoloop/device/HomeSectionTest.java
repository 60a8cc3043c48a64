package org.evoloop.device;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowable;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.evoloop.config.Options;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What is wrong in the section of Home Assistant is said with its line. */
class HomeSectionTest {
    @TempDir
    private Path folder;

    private String refused(String section) throws IOException {
        Files.writeString(folder.resolve("m.md"), """
                ```mermaid
                ---
                title: lamp
                ---
                stateDiagram-v2
                    [*] --> Off
                    Off --> On : switch
                    On --> Off : switch
                ```
                """);
        Path file = Files.writeString(folder.resolve("lamp.yaml"), """
                converter: lamp
                models: {original: m.md#lamp, new: m.md#lamp}
                connections: {lamp: {lines: "tcp://127.0.0.1:1"}}
                device: {send: {switch: SW}, readings: {power: {line: "P ([0-9]+)", unit: W}}}
                home-assistant:
                  %s
                """.formatted(section));
        return String.valueOf(catchThrowable(() -> DeviceFile.read(file, Options.of())));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "ligth: {} | 'ligth' is not known in home-assistant; did you mean light?",
                "light: {class: lamp} | 'lamp' is no class of a light",
                "light: {states: {On: onn}} | a light does not show 'onn'",
                "light: {modes: {none: On}} | 'none' is how Home Assistant calls no mode; call this one otherwise",
                "light: {reading: power} | a light shows no reading; a cover and a climate do",
                "climate: {states: {On: heat}, reading: powr} | 'powr' is no reading of the device; did you mean power?",
                "light: {presses: [swich]} | 'swich' is no event that a controller may raise; did you mean switch?",
                "light: [{name: Hall lamp}, {name: hall lamp}] | there is another light hall lamp; give each its own name",
                "event: {modes: {}} | an event needs modes, such as {done: Done}, its types",
                "select: {modes: {}} | a select needs modes, such as {done: Done}, its options",
                "button: {name: b} | a button needs commands, {press: STATE}",
                "light: {never-in: {On: [turn_of]}} | light has no command 'turn_of'; did you mean turn_off",
                "switch: {modes: {on: On}} | a switch has no modes; climate, event, fan, humidifier, light, select have",
            })
    void whatIsWrongIsSaidWithItsLine(String section, String mistake) throws IOException {
        assertThat(refused(section)).contains("lamp.yaml:6: " + mistake).doesNotContain("\n");
    }

    @ParameterizedTest
    @CsvSource({"100, false", "101, true"})
    void aNameHasALimit(int length, boolean refused) throws IOException {
        assertThat(refused("light: {name: " + "x".repeat(length) + "}").contains("at most 100 characters"))
                .isEqualTo(refused);
    }
}
