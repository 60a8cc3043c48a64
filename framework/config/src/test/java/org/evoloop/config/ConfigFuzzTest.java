package org.evoloop.config;

import static org.assertj.core.api.Assertions.assertThat;

import com.code_intelligence.jazzer.junit.FuzzTest;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.provider.MethodSource;

/** Any bytes are either refused with the file's name, or read, printed, and read again with the same result. */
@Timeout(value = 30, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class ConfigFuzzTest {
    @MethodSource("seeds")
    @FuzzTest
    void aFileOfAnyBytesIsReadOrRefused(byte[] bytes) throws IOException {
        Path file = Files.createTempFile("evoloop-fuzz", ".yaml");
        try {
            Files.write(file, bytes);
            Settings settings;
            try {
                settings = FanOptions.read("--simulate", "--print-config", "--config", file.toString());
            } catch (ConfigException refused) {
                assertThat(refused).hasMessageContaining(file.toString());
                return;
            }
            String printed = printed(settings);
            Files.writeString(file, printed);
            Settings again = FanOptions.read("--print-config", "--config", file.toString());
            assertThat(printed(again).replaceAll("(?m)  +# .*$", "")).isEqualTo(printed.replaceAll("(?m)  +# .*$", ""));
        } finally {
            Files.delete(file);
        }
    }

    private static String printed(Settings settings) {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        settings.answer(new PrintStream(out, true, StandardCharsets.UTF_8), System.err);
        return out.toString(StandardCharsets.UTF_8);
    }

    static Stream<byte[]> seeds() {
        return Stream.of(
                        "start: true\nspeed: 4\nbreeze-at:\n  - 08:00\n  - \"a\\tb\"\n",
                        "journal: 'x # y'\nbreeze-at: [\"\\u0085\", \"\\ud83d\\ude00\", '']\n",
                        "breeze-at: |\n  a\n  b\n",
                        "{start: true, breeze-at: [~, a]}",
                        "? start\n: true\n",
                        "start: &a true\nsimulate: *a",
                        "- a\n- b",
                        "%YAML 1.1\n---\nstart: true\n...\n",
                        "port: \"\\",
                        "\t",
                        "")
                .map(text -> text.getBytes(StandardCharsets.UTF_8));
    }
}
