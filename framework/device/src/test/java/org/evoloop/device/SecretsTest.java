package org.evoloop.device;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import ch.qos.logback.classic.Level;
import ch.qos.logback.classic.Logger;
import ch.qos.logback.classic.spi.ILoggingEvent;
import ch.qos.logback.core.read.ListAppender;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.stream.Collectors;
import org.evoloop.device.file.DeviceFileException;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.slf4j.LoggerFactory;

/** A device file's secrets are in no message, log or status. */
@Timeout(60)
class SecretsTest {
    private static final String SECRET = "s3cr3t";

    private static final String FILE = """
            converter: lamp
            models: {original: m.md#original, new: m.md#new}
            connections:
              api: {http: "http://127.0.0.1:1", poll: /state?key=s3cr3t, every: 50 ms, headers: {Authorization: Bearer s3cr3t}, header-files: {X-Key: password}}
              broker: {mqtt: "mqtt://me@127.0.0.1:1", password-file: password}
              tool: {program: [/no/such/tool, --token, s3cr3t]}
            device:
              send:
                power: {to: api, call: POST /power?key=s3cr3t, body: '{"token":"s3cr3t"}'}
                level: {run: ["false", s3cr3t]}
              state: {from: api, values: {is on: "On"}}
            controller:
              press: [{from: broker, topic: wall, values: {1: power}}]
            functions:
              Slow:
                on-enter: [{run: ["false", s3cr3t]}, {to: api, call: POST /slow?key=s3cr3t, body: s3cr3t}]
                on-exit: [{run: [/no/such/tool, s3cr3t]}]
            """;

    private static final String MODELS = """
            ## original

            ```mermaid
            stateDiagram-v2
                [*] --> Off
                Off --> On : power
                On --> Off : power
                Off --> Off : level
            ```

            ## new

            ```mermaid
            stateDiagram-v2
                [*] --> Off
                Off --> On : power
                On --> Off : power
                Off --> Off : level
                Off --> Slow : slow
                Slow --> Off : level
            ```
            """;

    @RegisterExtension
    private final TypedConsole console = new TypedConsole();

    private final ListAppender<ILoggingEvent> log = new ListAppender<>();
    private final Logger logger = (Logger) LoggerFactory.getLogger("org.evoloop");
    private final PrintStream err = System.err;
    private final ByteArrayOutputStream errors = new ByteArrayOutputStream();

    @TempDir
    private Path folder;

    @BeforeEach
    void listen() throws IOException {
        Files.writeString(folder.resolve("m.md"), MODELS);
        Files.writeString(folder.resolve("password"), SECRET);
        log.start();
        logger.setLevel(Level.DEBUG);
        logger.addAppender(log);
        System.setErr(new PrintStream(errors, true, StandardCharsets.UTF_8));
    }

    @AfterEach
    void restore() {
        System.setErr(err);
        logger.detachAppender(log);
        logger.setLevel(null);
    }

    private Path file(String text) throws IOException {
        return Files.writeString(folder.resolve("lamp.yaml"), text);
    }

    /** All that anybody could read. */
    private String shown() {
        return console.printed()
                + errors.toString(StandardCharsets.UTF_8)
                + List.copyOf(log.list).stream()
                        .map(event -> event.getFormattedMessage()
                                + (event.getThrowableProxy() == null
                                        ? ""
                                        : event.getThrowableProxy().getMessage()))
                        .collect(Collectors.joining("\n"));
    }

    @Test
    void aRunThatFailsEverywhereShowsNone() throws Exception {
        CompletableFuture<Integer> status = console.run(file(FILE), "--start");
        console.awaitStatus("lamp, running");
        console.type("press power");
        console.awaitHistory("power (controller)");
        console.type("press slow");
        console.awaitHistory("slow (controller)");
        console.type("press level");
        console.awaitHistory("level (controller)");
        await().until(() -> shown().contains("tool") && shown().contains("run false"));
        console.exit(status);
        assertThat(shown()).doesNotContain(SECRET);
    }

    @Test
    void whatIsPlayedOrOnlyShownShowsNone() throws Exception {
        CompletableFuture<Integer> status = console.run(file(FILE), "--simulate", "--start");
        console.awaitStatus("lamp, running");
        console.type("press slow");
        console.awaitHistory("slow (controller)");
        console.exit(status);
        Path token = Files.writeString(folder.resolve("token"), SECRET + SECRET + SECRET + SECRET);
        Files.setPosixFilePermissions(token, PosixFilePermissions.fromString("rw-------"));
        Path options = file(FILE + "page: 0\npage-token-file: token\nmqtt: mqtt://me@127.0.0.1:1\n"
                + "mqtt-password-file: password\n");
        assertThat(DeviceProgram.run(options, List.of("--print-config"))).isZero();
        assertThat(shown()).contains("mqtt-password-file").doesNotContain(SECRET);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "broker: {mqtt: \"mqtt://me:s3cr3t@127.0.0.1:1\"}",
                "broker: {mqtt: \"mqtt://me:s3cr3t@127.0.0.1:1:2\"}",
                "broker: {mqtt: \"mqtt://h\", password-file: password}",
                "broker: {mqtt: \"mqtt://h\", password: s3cr3t}",
                "api: {http: \"ftp://me:s3cr3t@h\"}",
                "api: {http: \"http://h\", headers: {\"a b\": s3cr3t}}",
                "api: {http: \"http://h\", headers: {a: \"s3cr3t\\u0007\"}, poll: /x}",
                "api: {http: \"http://h\", header-files: {\"a b\": password}}",
                "api: {http: \"http://h\", headers: {a: s3cr3t}, header-files: {a: password}}",
                "api: {http: \"http://h\", poll: \"no/path?key=s3cr3t\"}",
                "tool: {program: [\" \", s3cr3t]}",
                "mqtt: mqtt://me:s3cr3t@h",
            })
    void aMistakeInASecretsLineDoesNotShowIt(String line) throws IOException {
        boolean isOption = line.startsWith("mqtt:");
        String text = "converter: lamp\n" + (isOption ? line : "connections:\n  " + line) + "\n";
        Path file = file(text);
        String message = "";
        try {
            DeviceFile.read(file, DeviceProgram.options());
        } catch (DeviceFileException refused) {
            message = String.valueOf(refused.getMessage());
        }
        assertThat(message).startsWith(file + ":").doesNotContain(SECRET);
    }
}
