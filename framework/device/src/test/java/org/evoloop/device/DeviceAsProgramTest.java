package org.evoloop.device;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.api.io.TempDir;

/** A device that is a program of this computer, and programs that a function runs. */
@EnabledOnOs(OS.LINUX)
@Timeout(60)
class DeviceAsProgramTest {
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
                Timed : «device On»
                Timed --> Off : power
            ```
            """;

    @RegisterExtension
    private final TypedConsole console = new TypedConsole();

    @TempDir
    private Path folder;

    @BeforeEach
    void draw() throws IOException {
        Files.writeString(folder.resolve("lamp.md"), MODELS);
    }

    @Test
    void linesGoToAProgramAndAFunctionRunsOthers() throws Exception {
        Path heard = folder.resolve("heard");
        Path entered = folder.resolve("entered");
        Path left = folder.resolve("left");
        Path file = Files.writeString(folder.resolve("lamp.yaml"), """
                converter: lamp
                models: {original: lamp.md#original, new: lamp.md#new}
                connections: {lamp: {program: [sh, -c, "while read line; do echo $line >> %s; echo OK; done"]}}
                device:
                  send: {power: PWR}
                  answer: {within: 20 s}
                functions:
                  Timed: {on-enter: {run: [touch, %s]}, on-exit: {run: [touch, %s], within: 5 s}}
                """.formatted(heard, entered, left));
        CompletableFuture<Integer> status = console.run(file, "--start");
        console.awaitStatus("link        up");
        console.awaitStatus("lamp, running");
        console.type("press timed");
        await().until(() -> Files.exists(entered));
        console.type("press power");
        await().until(() -> Files.exists(left));
        assertThat(Files.readAllLines(heard)).containsExactly("PWR", "PWR");
        console.exit(status);
    }
}
