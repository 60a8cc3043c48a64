package org.evoloop.config;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** Which values are in force, where they came from, and that they can be written back to a file. */
class SettingsTest {
    @TempDir
    private Path folder;

    private static String answer(Settings settings) {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        assertThat(settings.answer(new PrintStream(out, true, StandardCharsets.UTF_8), System.err))
                .hasValue(0);
        return out.toString(StandardCharsets.UTF_8);
    }

    private Path fan(String text) throws IOException {
        return Files.writeString(folder.resolve("fan.yaml"), text);
    }

    @Test
    void aLineOfAnotherFileIsCheckedByItself() {
        List<String> refused = new ArrayList<>();
        Path file = Path.of("device.yaml");
        FanOptions.ALL.check(
                List.of(
                        new OptionLine("start", List.of("true"), false, file, 2),
                        new OptionLine("speed", List.of("fast"), false, file, 3)),
                (line, message) -> refused.add(line + ": " + message));
        assertThat(refused).singleElement().asString().startsWith("3: ").contains("fast");
    }

    @Test
    void theCommandLineWinsAndTakesThePlaceOfAnAlternative() throws IOException {
        Path file = fan("port: /dev/fan\nspeed: 4\nbreeze-at: [08:00]\n");
        Settings settings = FanOptions.read(
                "--config", file.toString(), "--simulate", "--speed=5", "--breeze-at", "1", "--breeze-at", "2");
        assertThat(settings.get(FanOptions.PORT)).isEmpty();
        assertThat(settings.get(FanOptions.SPEED)).contains(5);
        assertThat(settings.all(FanOptions.BREEZE_AT)).containsExactly("1", "2");
        assertThat(settings.isOn(FanOptions.SIMULATE)).isTrue();
    }

    @Test
    @EnabledOnOs(OS.LINUX)
    @Timeout(value = 60, threadMode = Timeout.ThreadMode.SEPARATE_THREAD) // opening a pipe cannot be interrupted
    void aFileAndASecretMayBePipes() throws Exception {
        Path secret = pipe("secret", "s3cret\n");
        Settings settings = FanOptions.read(
                "--config",
                pipe("fan.yaml", "simulate: true\nspeed: 4\n").toString(),
                "--fan-password-file",
                secret.toString());
        assertThat(settings.get(FanOptions.SPEED)).contains(4);
        assertThat(FanOptions.PASSWORD.in(settings)).contains("s3cret");
    }

    /** A pipe from which {@code text} can be read once. */
    private Path pipe(String name, String text) throws Exception {
        Path pipe = folder.resolve(name);
        assertThat(new ProcessBuilder("mkfifo", pipe.toString()).start().waitFor())
                .isZero();
        new ProcessBuilder("sh", "-c", "printf %s \"$1\" >\"$0\"", pipe.toString(), text).start();
        return pipe;
    }

    @Test
    void aRelativePathIsRelativeToItsFile() throws IOException {
        Files.writeString(folder.resolve("fan.xml"), "");
        Settings settings = FanOptions.read(
                "--config",
                fan("simulate: true\nmodels: fan.xml\njournal: kept").toString());
        assertThat(settings.get(FanOptions.MODELS)).contains(folder.resolve("fan.xml"));
        assertThat(settings.get(FanOptions.JOURNAL)).contains(folder.resolve("kept"));
        assertThat(FanOptions.read("--simulate", "--journal", "kept").get(FanOptions.JOURNAL))
                .contains(Path.of("kept"));
    }

    @Test
    void everyOptionIsPrintedWithWhereItCameFrom() throws IOException {
        Path secret = Files.writeString(folder.resolve("secret"), "s3cret\n");
        Path file = fan("start: true\nbreeze-at: [08:00, \"it's\"]\nfan-password-file: secret\n");
        String printed = answer(FanOptions.read("--config", file.toString(), "--port", "on", "--print-config"));
        assertThat(printed.replaceAll(" +", " ").lines())
                .containsExactly(
                        "program: fan # what this file is for",
                        "start: true # " + file + ":1",
                        "simulate: false # default",
                        "port: 'on' # command line",
                        "speed: 3 # default",
                        "breeze-at: ['08:00', 'it''s'] # " + file + ":2",
                        "# journal: # default: nowhere",
                        "# models: # default: not set",
                        "fan-password-file: " + quoted(secret) + " # " + file + ":3",
                        "# fan-password: (set, from " + secret + ")");
        assertThat(answer(
                        FanOptions.ALL.read(List.of("--simulate", "--print-config"), Map.of("FAN_PASSWORD", "s3cret"))))
                .contains("# fan-password: (set, from the environment, FAN_PASSWORD)")
                .doesNotContain("s3cret");
    }

    private static String quoted(Path path) {
        return path.toString().matches("[a-zA-Z0-9/_.+=-]*") ? path.toString() : "'" + path + "'";
    }

    @Test
    void whatIsPrintedSaysTheSameWhenItIsGivenBack() throws IOException {
        String odd = "a: b #c 'd' \"e\" \\ é\t{[&*!|>%@`,";
        Settings first = FanOptions.read("--print-config", "--port", odd, "--breeze-at", "null", "--journal", "kept");
        Path file = fan(answer(first));
        Settings again = FanOptions.read("--print-config", "--config", file.toString());
        assertThat(again.get(FanOptions.PORT)).contains(odd);
        assertThat(again.all(FanOptions.BREEZE_AT)).containsExactly("null");
        assertThat(again.get(FanOptions.JOURNAL)).contains(Path.of("kept").toAbsolutePath());
        assertThat(withoutOrigins(answer(again))).isEqualTo(withoutOrigins(answer(first)));
    }

    private static String withoutOrigins(String printed) {
        return printed.replaceAll("(?m)  +# .*$", "");
    }

    @Test
    void helpNamesEveryOptionAndNothingElseIsLookedAt() {
        assertThat(answer(FanOptions.read("--help", "--speed", "12")))
                .startsWith("Usage: fan [-h] [--print-config] [--simulate] [--start]")
                .contains("Runs a fan.", "--breeze-at=TIME", "--config=FILE", "--print-config")
                .contains("Exit status");
        assertThat(FanOptions.read("--simulate").answer(System.out, System.err)).isEmpty();
    }

    @Test
    @EnabledOnOs(OS.LINUX)
    void aFullDiskIsAnError() throws IOException {
        for (String asked : List.of("--help", "--print-config")) {
            ByteArrayOutputStream err = new ByteArrayOutputStream();
            try (PrintStream full = new PrintStream(new FileOutputStream("/dev/full"), false, StandardCharsets.UTF_8)) {
                assertThat(FanOptions.read("--simulate", asked)
                                .answer(full, new PrintStream(err, true, StandardCharsets.UTF_8)))
                        .hasValue(1);
            }
            assertThat(err.toString(StandardCharsets.UTF_8))
                    .startsWith("error: standard output: the result could not be written in full; ")
                    .hasLineCount(1);
        }
    }

    /** A password in a URL is printed nowhere, whatever the option and the mistake; a port is no password. */
    @Test
    void noPasswordInAUrlIsPrinted() throws IOException {
        String url = "mqtt://me:s3cr/e@t@host:1883/a";
        assertThat(answer(FanOptions.read("--port", url, "--print-config")))
                .contains("port: 'mqtt://me:***@host:1883/a'")
                .doesNotContain("s3cr");
        String plain = "http://host:8080/feed@2x";
        assertThat(answer(FanOptions.read("--port", plain, "--print-config"))).contains("port: '" + plain + "'");
        for (String[] wrong : new String[][] {
            {url},
            {"--speed", url},
            {"--sped", url},
            {"--simulate=" + url},
            {"--config", fan("speed: " + url).toString()},
            {"--config", fan("prot: " + url + "\nspeed: 3\n" + url + "\n").toString()},
            {"--config", url}
        }) {
            assertThatThrownBy(() -> FanOptions.read(wrong))
                    .isInstanceOf(ConfigException.class)
                    .hasMessageNotContaining("s3cr");
        }
    }
}
