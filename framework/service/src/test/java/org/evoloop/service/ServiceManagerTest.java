package org.evoloop.service;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.io.InputStream;
import java.io.OutputStream;
import java.io.PrintStream;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import org.evoloop.Logged;
import org.evoloop.console.Console;
import org.evoloop.converter.PushMonitor;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.time.ManualClock;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(60)
class ServiceManagerTest {
    private final ManualClock clock = new ManualClock();
    private final SystemEventConverter converter =
            LampProgram.converter(new PushMonitor("WallSwitch"), new ManualClock());
    private final PrintStream nowhere = new PrintStream(OutputStream.nullOutputStream());
    private final Console console = new Console(converter, InputStream.nullInputStream(), nowhere, nowhere);

    /** The warnings that are logged if {@code end} runs between two checks. */
    private List<String> warningsOf(Runnable end) {
        try (Logged logged = new Logged("org.evoloop.service");
                ServiceManager manager = new ServiceManager(Map.of(), console, clock, true)) {
            manager.ready();
            await().until(() -> clock.pendingTasks() == 1);
            end.run();
            clock.advance(Duration.ofSeconds(1));
            await().until(() -> Thread.getAllStackTraces().keySet().stream()
                    .noneMatch(thread -> thread.getName().equals("evoloop-pulse")));
            return logged.lines();
        }
    }

    @Test
    void theProgramEndsWithAConverterThatSomethingElseClosed() {
        assertThat(warningsOf(converter::close))
                .containsExactly("the converter was closed by a component of its own; the program ends");
        assertThat(console.isEnding()).isTrue();
    }

    @Test
    void aProgramThatEndsAnywayIsNotSaidToEndWithItsConverter() {
        assertThat(warningsOf(() -> {
                    console.end("SIGTERM", 0);
                    converter.close();
                }))
                .isEmpty();
    }
}
