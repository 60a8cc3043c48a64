package org.evoloop.device;

import static org.assertj.core.api.Assertions.assertThat;

import com.code_intelligence.jazzer.junit.FuzzTest;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import org.evoloop.device.file.DeviceFileException;
import org.evoloop.statemachine.ModelException;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.provider.MethodSource;

/** Any bytes are either refused with the file's name in each line, or a converter whose scenarios pass or fail. */
@Timeout(value = 30, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class DeviceFileFuzzTest {
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
                Timed --> Off : power
            ```
            """;

    @MethodSource("seeds")
    @FuzzTest
    void aDeviceFileOfAnyBytesIsReadOrRefused(byte[] bytes) throws IOException {
        Path folder = Files.createTempDirectory("evoloop-fuzz");
        Path models = Files.writeString(folder.resolve("m.md"), MODELS);
        Path file = Files.write(folder.resolve("f.yaml"), bytes);
        try {
            DeviceFile read = DeviceFile.read(file, DeviceProgram.options());
            read.scenarios().forEach(scenario -> assertThat(scenario.run(read)).isNotNull());
        } catch (DeviceFileException refused) {
            assertThat(refused.getMessage()).startsWith(file.toString());
        } catch (ModelException unfit) {
            // The converter cannot be built; check reports it.
            assertThat(unfit.getMessage()).isNotBlank();
        } finally {
            Files.delete(file);
            Files.delete(models);
            Files.delete(folder);
        }
    }

    static Stream<byte[]> seeds() {
        return Stream.of(
                        """
                        converter: lamp
                        models: {original: m.md#original, new: m.md#new}
                        connections: {lamp: {lines: "tcp://h:1", greet: [a, b], watch: {after: 1 s, ask: q}}}
                        device:
                          send: {power: {line: P, cost: 2}}
                          answer: {ok: OK, error: E, within: 1 s}
                          ask: {line: q}
                          state: {x: On}
                          readings: {t: {line: "(.)", unit: C}}
                        controller: {press: [{values: {a: timed}}, {line: "b(?<n>.)", event: power}]}
                        functions: {Timed: {every: 1 s, send: power, at: [{time: "07:30", say: x}], on-exit: {to: lamp, line: l}}}
                        schedule: {power: ["09:00", "MON,FRI 18:30"]}
                        quiet: {between: ["22:00", "07:00"], refuse: [timed]}
                        scenarios: {s: [{press: timed, state: Timed}, {after: 2 s, sent: [power]}]}
                        """,
                        "converter: a\nconnections: {b: {lines: \"tcp://h:1\"}}\ndevice: {send: {e: E}}\n",
                        "converter: [a]\nmodels: b\n",
                        "a: &b c\nd: *b\n",
                        "{",
                        "\"\\",
                        "")
                .map(text -> text.getBytes(StandardCharsets.UTF_8));
    }
}
