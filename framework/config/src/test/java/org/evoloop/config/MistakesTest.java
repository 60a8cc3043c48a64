package org.evoloop.config;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** All mistakes are reported at once, wherever they are. */
class MistakesTest {
    @TempDir
    private Path folder;

    @Test
    void allMistakesOfFileAndCommandLineAreOneMessage() throws IOException {
        Path file = Files.writeString(folder.resolve("fan.yaml"), """
                spede: 3
                speed: 12
                speed: 4
                port: /dev/fan
                simulate: true
                models: gone.xml
                breeze-at:
                  - 08:00
                  - {a: b}
                journal: [a, b]
                """);
        assertThatThrownBy(() -> FanOptions.read("--strat", "--config", file.toString(), "--fan-password-file"))
                .isInstanceOf(ConfigException.class)
                .message()
                .satisfies(error -> assertThat(
                                error.replace(folder.toString(), "D").lines())
                        .containsExactlyInAnyOrder(
                                "the options have 9 mistakes:",
                                "  --fan-password-file needs a value: --fan-password-file FILE",
                                "  there is no option --strat; did you mean start?",
                                "  D/fan.yaml:1: there is no option spede; did you mean speed?",
                                "  D/fan.yaml:2: speed is 12, allowed is 1 to 9",
                                "  D/fan.yaml:3: speed is given twice, first in line 2; keep one",
                                "  D/fan.yaml:4: say which fan: port PATH or simulate",
                                "  D/fan.yaml:6: models is D/gone.xml, which does not exist; correct the path",
                                "  D/fan.yaml:9: a value is expected, not a mapping; an option takes text, "
                                        + "true or false, or a list of texts",
                                "  D/fan.yaml:10: journal takes one value, not a list"));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "--simulate --speed 12|--speed is 12, allowed is 1 to 9",
                "--simulate --speed|--speed needs a value: --speed N",
                "--speed --simulate|--speed needs a value: --speed N",
                "--simulate --simulate|--simulate is given twice; keep one",
                "--simulate=maybe|--simulate: 'maybe' is neither true nor false; write one of them",
                "--simulate --nonsense value|there is no option --nonsense; see fan --help",
                "--simulate again|'again' does not belong to an option; options begin with --, and values with spaces "
                        + "are quoted",
                "--simulate --journal=|--journal has an empty value; write one, or leave it out",
                "--start|say which fan: --port PATH or --simulate",
            })
    void mistakesOfACommandLine(String arguments, String message) {
        assertThatThrownBy(() -> FanOptions.read(arguments.split(" ")))
                .isInstanceOf(ConfigException.class)
                .hasMessage(message);
    }

    @Test
    void whatCouldNotBeReadLeadsToNoFurtherMistake() throws IOException {
        Path file = Files.writeString(folder.resolve("fan.yaml"), "port: \"/dev");
        assertThatThrownBy(() -> FanOptions.read("--config", file.toString()))
                .message()
                .startsWith(file + ":1: this is not YAML")
                .doesNotContain("which fan");
        assertThatThrownBy(() -> FanOptions.read("--port")).hasMessage("--port needs a value: --port PATH");
    }

    @Test
    void controlCharactersAreNotPassedOnToTheTerminal() throws IOException {
        Path file = Files.writeString(
                folder.resolve("fan.yaml"),
                "simulate: true\nprogram: \"\\e[2J\"\n\"a\\nerror: b\": 1\n\"c\\x9bd\": 1\n");
        assertThatThrownBy(() -> FanOptions.read("--config", file.toString()))
                .message()
                .satisfies(error -> assertThat(
                                error.replace(folder.toString(), "D").lines())
                        .containsExactly(
                                "the options have 3 mistakes:",
                                "  D/fan.yaml:2: program is ?[2J, but this is fan; name another file, or correct the line",
                                "  D/fan.yaml:3: there is no option a?error: b; see fan --help",
                                "  D/fan.yaml:4: there is no option c?d; see fan --help"));
    }

    @Test
    void aSecretThatCannotBeHadIsAMistake() throws IOException {
        Path empty = Files.createFile(folder.resolve("empty"));
        assertThatThrownBy(() -> FanOptions.read("--simulate", "--fan-password-file", empty.toString()))
                .hasMessage("--fan-password-file is " + empty + ", which is empty; write the secret into it");
        assertThatThrownBy(() -> FanOptions.read(
                        "--simulate",
                        "--fan-password-file",
                        folder.resolve("no").toString()))
                .hasMessageContaining("which cannot be read; check that it is there");
        Path latin = Files.writeString(folder.resolve("latin"), "gehe\u00efm", StandardCharsets.ISO_8859_1);
        assertThatThrownBy(() -> FanOptions.read("--simulate", "--fan-password-file", latin.toString()))
                .hasMessage(
                        "--fan-password-file is " + latin + ", which is not text in UTF-8; save it in this encoding");
        Path large = Files.writeString(folder.resolve("large"), "s".repeat(4097));
        assertThatThrownBy(() -> FanOptions.read("--simulate", "--fan-password-file", large.toString()))
                .hasMessage("--fan-password-file is " + large
                        + ", which is larger than 4096 bytes; name a file that holds nothing but the secret");
        assertThat(FanOptions.PASSWORD.in(FanOptions.ALL.read(List.of("--simulate"), Map.of("FAN_PASSWORD", "s3cret"))))
                .contains("s3cret");
    }
}
