package org.evoloop.device;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import org.evoloop.mqtt.Mosquitto;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.api.io.TempDir;

/** {@code devices/time-clock} with Debian's editor ed: judged by the file that ed writes. */
@EnabledOnOs(OS.LINUX)
@Timeout(60)
class TimeClockTest {
    private static final Path CLOCK = Path.of(System.getProperty("evoloop.root", "../.."), "devices", "time-clock");

    @RegisterExtension
    private final TypedConsole console = new TypedConsole();

    @TempDir
    private Path folder;

    @Test
    void aPressIsWrittenAndASecondOneTakesItBack() throws Exception {
        Path stamps = Files.writeString(folder.resolve("stamps.txt"), "stamps\n");
        Files.writeString(
                folder.resolve("README.md"),
                Files.readString(CLOCK.resolve("README.md")).replace("after 2 s", "after 1 s"));
        Path file = Files.writeString(
                folder.resolve("time-clock.yaml"),
                Files.readString(CLOCK.resolve("time-clock.yaml"))
                        .replace("[ed, stamps.txt]", "[" + Mosquitto.program("ed") + ", " + stamps + "]"));
        CompletableFuture<Integer> status = console.run(file, "--start");
        console.awaitStatus("link        up");
        console.awaitStatus("time-clock, running");
        console.type("press press");
        await().until(() -> lines(stamps).size() == 2);
        console.awaitHistory("(Stamped, Fresh) -> (Written, Written)");
        String first = lines(stamps).get(1);
        console.type("press press");
        console.awaitHistory("(Written, Written) -> (Stamped, Fresh)");
        console.type("press press");
        console.awaitHistory("(Stamped, Fresh) -> (TakenBack, TakenBack)");
        console.type("press press");
        console.awaitHistory("(TakenBack, TakenBack) -> (Stamped, Fresh)");
        await().until(() -> lines(stamps).size() == 3);
        assertThat(lines(stamps)).startsWith("stamps", first);
        console.exit(status);
    }

    private static List<String> lines(Path stamps) throws IOException {
        return Files.readAllLines(stamps);
    }
}
