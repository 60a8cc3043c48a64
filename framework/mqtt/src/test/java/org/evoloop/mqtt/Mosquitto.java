package org.evoloop.mqtt;

import static org.assertj.core.api.Assertions.fail;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.awaitility.Awaitility;

/** Debian's MQTT broker, on a port of its own, with what it retains in memory only: a restart forgets everything. */
final class Mosquitto implements AutoCloseable {
    private final Path directory;
    private final int port;
    private final List<String> lines = new ArrayList<>();
    private Process process;

    /** A broker that lets everybody in; not started. */
    Mosquitto(Path directory) {
        this.directory = directory;
        this.port = freePort();
        lines.add("listener " + port + " 127.0.0.1");
        lines.add("persistence false");
    }

    private static int freePort() {
        try (ServerSocket socket = new ServerSocket(0)) {
            return socket.getLocalPort();
        } catch (IOException failure) {
            throw new UncheckedIOException(failure);
        }
    }

    /** Adds lines to its configuration. */
    Mosquitto with(String... more) {
        lines.addAll(List.of(more));
        return this;
    }

    Mosquitto start() {
        try {
            Path config = directory.resolve("mosquitto-" + port + ".conf");
            List<String> all = new ArrayList<>(lines);
            if (lines.stream().noneMatch(line -> line.startsWith("allow_anonymous"))) {
                all.add("allow_anonymous true");
            }
            Files.write(config, all);
            process = new ProcessBuilder(program("mosquitto"), "-c", config.toString())
                    .redirectErrorStream(true)
                    .redirectOutput(
                            directory.resolve("mosquitto-" + port + ".log").toFile())
                    .start();
        } catch (IOException failure) {
            throw new UncheckedIOException(failure);
        }
        Awaitility.await().atMost(Duration.ofSeconds(20)).until(this::listens);
        return this;
    }

    private boolean listens() {
        if (!process.isAlive()) {
            fail("mosquitto has ended; see its log in " + directory);
        }
        try (Socket socket = new Socket()) {
            socket.connect(new InetSocketAddress("127.0.0.1", port), 1000);
            return true;
        } catch (IOException notYet) {
            return false;
        }
    }

    /** The path of a program of the package; Debian keeps the broker where only root looks. */
    static String program(String name) {
        String path = System.getenv("PATH") + ":/usr/sbin:/usr/local/sbin";
        return Stream.of(path.split(":"))
                .map(folder -> Path.of(folder, name))
                .filter(Files::isExecutable)
                .findFirst()
                .orElseThrow(() -> new AssertionError("there is no " + name + ", which this test needs; ./evoloop test "
                        + "installs it, and so does: apt-get install " + name))
                .toString();
    }

    int port() {
        return port;
    }

    String url() {
        return "mqtt://127.0.0.1:" + port;
    }

    /** Kills it: whoever is connected learns of it by the end of the connection only. */
    void stop() {
        process.destroyForcibly();
        try {
            process.waitFor(20, TimeUnit.SECONDS);
        } catch (InterruptedException interrupt) {
            Thread.currentThread().interrupt();
        }
    }

    @Override
    public void close() {
        if (process != null) {
            stop();
        }
    }
}
