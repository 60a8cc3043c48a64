package org.evoloop.service;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import org.evoloop.JavaProcess;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The notifications to a service manager, received on a datagram socket like the manager's. */
@Timeout(value = 120, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
@EnabledOnOs(OS.LINUX)
class NotifyTest {
    /** Prints each message as one line, with spaces for line feeds; messages that only mark an end are left out. */
    private static final String MANAGER = """
            import socket, sys
            address = sys.argv[1]
            manager = socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM)
            manager.bind(chr(0) + address[1:] if address[0] == "@" else address)
            print("bound", flush=True)
            while True:
                message = manager.recv(65536).decode()
                if message != "BARRIER=1":
                    print(message.replace(chr(10), " "), flush=True)
            """;

    @TempDir
    private Path runtime;

    private Process manager;
    private Process lamp;

    @AfterEach
    void leaveNoProcess() throws InterruptedException {
        for (Process process : new Process[] {manager, lamp}) {
            if (process != null) {
                process.destroyForcibly().waitFor();
            }
        }
    }

    private static boolean hasPrograms() {
        return hasProgram("python3") && hasProgram("systemd-notify");
    }

    private static boolean hasProgram(String name) {
        try {
            return new ProcessBuilder(name, "--version").start().waitFor() == 0;
        } catch (IOException none) {
            return false;
        } catch (InterruptedException stop) {
            Thread.currentThread().interrupt();
            return false;
        }
    }

    private BufferedReader manage(String address) throws IOException {
        manager = new ProcessBuilder("python3", "-c", MANAGER, address).start();
        BufferedReader messages = manager.inputReader(StandardCharsets.UTF_8);
        assertThat(messages.readLine()).isEqualTo("bound");
        return messages;
    }

    private void startLamp(String address, String watchdogMicros) throws IOException {
        ProcessBuilder builder = new ProcessBuilder(JavaProcess.command(LampProgram.class, "--start", "--name", "lamp"))
                .redirectOutput(ProcessBuilder.Redirect.DISCARD)
                .redirectError(ProcessBuilder.Redirect.DISCARD);
        builder.environment()
                .putAll(Map.of(
                        "NOTIFY_SOCKET", address,
                        "WATCHDOG_USEC", watchdogMicros,
                        "XDG_RUNTIME_DIR", runtime.toString()));
        lamp = builder.start();
    }

    /** The next message that begins like this; a busy computer may give the lamp's clock no turn for a second. */
    private static String next(BufferedReader messages, String beginning) throws IOException {
        String message = messages.readLine();
        while (!message.startsWith(beginning)) {
            message = messages.readLine();
        }
        return message;
    }

    private void command(String command) throws Exception {
        try (Client client = new Client(runtime.resolve("evoloop/lamp.sock"))) {
            client.send(command + "\n");
            assertThat(client.line()).isEqualTo("end 0");
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"file", "@evoloop-test"})
    void itIsReadyThenAliveThenStopping(String kind) throws Exception {
        assumeTrue(hasPrograms());
        String address = kind.equals("file")
                ? runtime.resolve("notify").toString()
                : kind + ProcessHandle.current().pid();
        BufferedReader messages = manage(address);
        startLamp(address, "600000");

        assertThat(messages.readLine()).isEqualTo("READY=1 STATUS=lamp running: off / off");
        assertThat(next(messages, "WATCHDOG=1")).isEqualTo("WATCHDOG=1 STATUS=lamp running: off / off");
        command("exit");
        assertThat(next(messages, "STOPPING=1")).isEqualTo("STOPPING=1 STATUS=stopping: exit");
    }

    @ParameterizedTest
    @ValueSource(strings = {"TERM", "HUP"})
    void aProgramThatIsReadyHandlesSignals(String signal) throws Exception {
        assumeTrue(hasPrograms());
        String address = runtime.resolve("notify").toString();
        BufferedReader messages = manage(address);
        startLamp(address, "600000");
        assertThat(messages.readLine()).startsWith("READY=1");

        JavaProcess.signal(signal, lamp);

        if (signal.equals("HUP")) {
            next(messages, "WATCHDOG=1");
            JavaProcess.signal("TERM", lamp);
        }
        assertThat(next(messages, "STOPPING=1")).isEqualTo("STOPPING=1 STATUS=stopping: SIGTERM");
        assertThat(lamp.waitFor(60, TimeUnit.SECONDS)).isTrue();
        assertThat(lamp.exitValue()).isZero();
    }

    @Test
    void theWatchdogReceivesNothingFromALoopThatHangs() throws Exception {
        assumeTrue(hasPrograms());
        String address = runtime.resolve("notify").toString();
        BufferedReader messages = manage(address);
        startLamp(address, "600000");
        assertThat(messages.readLine()).startsWith("READY=1");
        next(messages, "WATCHDOG=1");

        command("hang");

        assertThat(next(messages, "STATUS=")).isEqualTo("STATUS=lamp has a clock that does not run its tasks");
        command("exit");
        assertThat(messages.readLine()).startsWith("STOPPING=1");
    }

    @Test
    void theWatchdogIsHeededOnlyByTheProcessThatItIsFor() {
        long own = ProcessHandle.current().pid();
        Map<String, String> watched = Map.of("NOTIFY_SOCKET", "/run/n", "WATCHDOG_USEC", "3000000");

        assertThat(new Notifier(watched).watchdog()).isEqualTo(Duration.ofSeconds(3));
        assertThat(new Notifier(Map.of("WATCHDOG_USEC", "3000000")).watchdog()).isNull();
        assertThat(new Notifier(Map.of("NOTIFY_SOCKET", "/run/n", "WATCHDOG_USEC", "x")).watchdog())
                .isNull();
        assertThat(new Notifier(Map.of("NOTIFY_SOCKET", "/n", "WATCHDOG_USEC", "3000000", "WATCHDOG_PID", own + "1"))
                        .watchdog())
                .isNull();
    }
}
