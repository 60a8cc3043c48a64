package org.evoloop.config;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Valid files, and invalid ones, for which one message names the line. */
@Timeout(60)
class ConfigFileTest {
    @TempDir
    private Path folder;

    private Path file(String text) throws IOException {
        return Files.writeString(folder.resolve("fan.yaml"), text);
    }

    private Settings read(String text) throws IOException {
        return FanOptions.read("--config", file(text).toString());
    }

    private void assertRefused(Path file, String message) {
        assertThatThrownBy(() -> FanOptions.read("--config", file.toString()))
                .isInstanceOf(ConfigException.class)
                .message()
                .satisfies(
                        error -> assertThat(error.replace(file.toString(), "F")).isEqualTo(message));
    }

    @Test
    void aFileSaysWhatACommandLineSays() throws IOException {
        Settings settings =
                read("program: fan\nport: /dev/fan#1\nspeed: 7 # fast\nbreeze-at: [08:00, '0755']\nstart: true\n");
        assertThat(settings.get(FanOptions.PORT)).contains("/dev/fan#1");
        assertThat(settings.get(FanOptions.SPEED)).contains(7);
        assertThat(settings.all(FanOptions.BREEZE_AT)).containsExactly("08:00", "0755");
        assertThat(settings.isOn(FanOptions.START)).isTrue();
        assertThat(settings.isOn(FanOptions.SIMULATE)).isFalse();
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "breeze-at: 08:00",
                "breeze-at: '08:00'",
                "breeze-at:\n- 08:00",
                "{breeze-at: '08:00'}",
                "\uFEFFbreeze-at: 08:00",
                "breeze-at: \"08:00\"\r\n"
            })
    void aValueIsTakenAsItIsWritten(String text) throws IOException {
        assertThat(FanOptions.read("--simulate", "--config", file(text).toString())
                        .all(FanOptions.BREEZE_AT))
                .containsExactly("08:00");
    }

    @ParameterizedTest
    @ValueSource(strings = {"on", "off", "no", "0x1F", "1e3", "12:30:45", "0123", "=", "2026-11-23"})
    void wordsThatOlderYamlTookForSomethingElseAreText(String word) throws IOException {
        assertThat(read("port: " + word).get(FanOptions.PORT)).contains(word);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "''|F: is empty; write each option as NAME: VALUE on a line of its own",
                "# x|F: is empty; write each option as NAME: VALUE on a line of its own",
                "- port|F:1: this is a list, not a list of options with values; write each option as NAME: VALUE on a line of its own",
                "port:/dev/fan|F:1: this is a text, not a list of options with values; write each option as NAME: VALUE on a line of its own",
                "simulate: yes|F:1: simulate: 'yes' is neither true nor false; write one of them",
                "port: #1|F:1: there is no value; write one (in quotes if it begins with #), or leave the line out",
                "port: ''|F:1: port has an empty value; write one, or leave it out",
                "port: [a]|F:1: port takes one value, not a list",
                "port: {a: b}|F:1: a value is expected, not a mapping; an option takes text, true or false, or a list of texts",
                "prot: a|F:1: there is no option prot; did you mean port?",
                "config: a|F:1: config belongs on the command line",
                "program: lamp|F:1: program is lamp, but this is fan; name another file, or correct the line",
                "fan-password: x|F:1: there is no option fan-password, since others could read it; put the secret into a file, and "
                        + "name that with fan-password-file",
            })
    void oneMistakeIsOneLine(String text, String message) throws IOException {
        String whole = text.startsWith("simulate") || text.startsWith("port") || !text.contains(": ")
                ? text
                : text + "\nsimulate: true";
        assertRefused(file(whole), message);
    }

    @ParameterizedTest
    @CsvSource({
        "'simulate: true\n\tspeed: 3', F:2:, spaces instead of tabs",
        "'simulate: true\nspeed: \"3', F:2:, quotes",
        "'simulate: true\nport: \"\\u', F:2:, in the middle of an escape",
        "'simulate: true\nport: \"\\U00110000\"', F:2:, escape",
        "'simulate: true\nport: a: b', F:2:, colon",
        "'simulate: true\nport: [a', F:, bracket",
        "'simulate: true\nport: @a', F:2:, put the value in quotes",
        "'simulate: &a true\nport: *a', F:1:, anchors",
        "'simulate: true\nport: !!str a', F:2:, tags",
        "'simulate: true\nport: [&a {b: c}, d]', F:2:, anchors",
        "'simulate: true\n---\nport: a', F:2:, second document",
        "'simulate: true\n? [a]\n: b', F:2:, name is expected",
    })
    void whatIsNotAMappingOfTextsIsRefusedWithItsPlace(String text, String place, String remedy) throws IOException {
        Path file = file(text.replace("\\t", "\t"));
        assertThatThrownBy(() -> FanOptions.read("--config", file.toString()))
                .isInstanceOf(ConfigException.class)
                .message()
                .satisfies(error -> assertThat(error.replace(file.toString(), "F"))
                        .contains(place)
                        .contains(remedy));
    }

    @Test
    void aBombOfAliasesIsRefusedAtOnce() throws IOException {
        StringBuilder bomb = new StringBuilder("a0: &a0 [x, x, x, x, x, x, x, x, x]\n");
        for (int i = 1; i < 40; i++) {
            bomb.append("a" + i + ": &a" + i + " [" + ("*a" + (i - 1) + ", ").repeat(9) + "x]\n");
        }
        Path file = file(bomb.toString());
        assertThatThrownBy(() -> FanOptions.read("--config", file.toString()))
                .isInstanceOf(ConfigException.class)
                .hasMessageContaining(file + ":40: anchors (&) and aliases (*) are not supported");
    }

    @Test
    void deepNestingAndLongLinesAreRefusedAtOnce() throws IOException {
        assertThatThrownBy(() -> read("port: " + "[".repeat(60_000))).isInstanceOf(ConfigException.class);
        assertThatThrownBy(() -> read("x".repeat(60_000) + ": a")).isInstanceOf(ConfigException.class);
    }

    @Test
    void whatIsNoTextFileIsOneLine() throws IOException {
        assertRefused(folder, "F: is a directory; name a file in it");
        assertRefused(folder.resolve("none.yaml"), "F: does not exist; correct the path");
        assertRefused(Path.of("/dev/zero"), "F: is larger than 64 kB, which no configuration is; correct the path");
        Path latin =
                Files.write(folder.resolve("latin.yaml"), "start: true\nport: é".getBytes(StandardCharsets.ISO_8859_1));
        assertRefused(latin, "F:2: byte 0xE9 is not UTF-8; save the file in this encoding");
        assertRefused(
                file("start: true\nport: a\u0000b"), "F:2: the control character U+0000 is not allowed; remove it");
    }
}
