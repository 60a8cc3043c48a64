package org.evoloop.mqtt;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.time.Duration;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import org.evoloop.Logged;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Faults of Debian's Mosquitto are reported once, connecting is retried, and no retained state is lost afterwards. */
class BrokerFaultsTest {
    private static final Duration LIMIT = Duration.ofSeconds(60);

    /** The fixture's own check whether the broker listens may leave a trace in the log, too. */
    private static final int TRIES = 4;

    @TempDir
    private Path directory;

    private final Logged logged = new Logged("org.evoloop.mqtt");

    @AfterEach
    void endLog() {
        logged.close();
    }

    private static BrokerAddress address(Mosquitto broker) {
        return BrokerAddress.parse("mqtt://ha@127.0.0.1:" + broker.port());
    }

    private static BrokerConnection reporting(BrokerAddress address) {
        BrokerConnection connection = new BrokerConnection(address, "telling");
        connection.publish(Message.state("lamp/state", "on"));
        connection.open();
        return connection;
    }

    /** The retained messages received so far, by topic. */
    private static Map<String, String> retained(BrokerConnection asking, String... topics) {
        Map<String, String> found = new ConcurrentHashMap<>();
        for (String topic : topics) {
            asking.subscribe(topic, message -> {
                if (message.kind() == Message.Kind.STATE) {
                    found.put(topic, message.payload());
                }
            });
        }
        asking.open();
        return found;
    }

    /** Pauses start at 250 ms and grow, so a few tries take seconds. */
    private static void awaitTries(Mosquitto broker, String sign) {
        await().atMost(LIMIT).until(() -> broker.logged(sign) >= TRIES);
    }

    private void setPassword(Path passwords, String password) throws Exception {
        assertThat(new ProcessBuilder(Mosquitto.program("mosquitto_passwd"), "-b", passwords.toString(), "ha", password)
                        .inheritIO()
                        .start()
                        .waitFor())
                .isZero();
    }

    @Test
    void aPasswordThatIsWrongAtFirst() throws Exception {
        Path passwords = Files.createFile(directory.resolve("passwords"));
        setPassword(passwords, "another");
        try (Mosquitto broker = new Mosquitto(directory)
                        .with("user root", "allow_anonymous false", "password_file " + passwords)
                        .start();
                BrokerConnection connection = reporting(address(broker).withPassword("right"))) {
            awaitTries(broker, "not authori");
            assertThat(logged.lines()).hasSize(1).allMatch(line -> line.contains("refuses the login of user ha"));
            connection.publish(Message.state("lamp/power", "5"));
            setPassword(passwords, "right");
            broker.stop();
            broker.start();
            await().atMost(LIMIT).until(connection::isUp);
            try (BrokerConnection other = new BrokerConnection(address(broker).withPassword("right"), "other")) {
                Map<String, String> found = retained(other, "lamp/state", "lamp/power");
                await().atMost(LIMIT)
                        .untilAsserted(
                                () -> assertThat(found).isEqualTo(Map.of("lamp/state", "on", "lamp/power", "5")));
            }
            assertThat(logged.lines().stream().filter(line -> line.contains("refuses the login")))
                    .hasSize(1);
        }
    }

    @ParameterizedTest
    @CsvSource({"foreign,ip:127.0.0.1", "misnamed,dns:elsewhere"})
    void aCertificateThatIsNotToBeTrustedAtFirst(String name, String subject) throws Exception {
        Certificate own = Certificate.of(directory, "own", "ip:127.0.0.1");
        Certificate wrong = Certificate.of(directory, name, subject);
        Path trusted = directory.resolve("trusted.pem");
        Files.writeString(
                trusted,
                Files.readString(own.certificate())
                        + (name.equals("misnamed") ? Files.readString(wrong.certificate()) : ""));
        Certificate shown = new Certificate(directory.resolve("shown.crt"), directory.resolve("shown.key"));
        show(wrong, shown);
        try (Mosquitto broker = new Mosquitto(directory)
                .with("user root", "certfile " + shown.certificate(), "keyfile " + shown.key())
                .start()) {
            BrokerAddress address = BrokerAddress.parse("mqtts://127.0.0.1:" + broker.port() + "?ca=" + trusted);
            try (BrokerConnection connection = reporting(address)) {
                awaitTries(broker, "OpenSSL Error");
                assertThat(logged.lines()).hasSize(1).allMatch(line -> line.contains("is not trusted"));
                connection.publish(Message.state("lamp/power", "5"));
                broker.stop();
                show(own, shown);
                broker.start();
                await().atMost(LIMIT).until(connection::isUp);
                try (BrokerConnection other = new BrokerConnection(address, "other")) {
                    Map<String, String> found = retained(other, "lamp/state", "lamp/power");
                    await().atMost(LIMIT)
                            .untilAsserted(
                                    () -> assertThat(found).isEqualTo(Map.of("lamp/state", "on", "lamp/power", "5")));
                }
                assertThat(logged.lines().stream().filter(line -> line.contains("is not trusted")))
                        .hasSize(1);
            }
        }
    }

    private static void show(Certificate certificate, Certificate shown) throws IOException {
        Files.copy(certificate.certificate(), shown.certificate(), StandardCopyOption.REPLACE_EXISTING);
        Files.copy(certificate.key(), shown.key(), StandardCopyOption.REPLACE_EXISTING);
    }

    /**
     * Mosquitto accepts messages that it can no longer write, and only logs the error. It may refuse to read the
     * incomplete file; without that file it starts again.
     */
    @Test
    void aDiskThatIsFull() throws Exception {
        Path kept = Files.createDirectory(directory.resolve("kept"));
        try (Mosquitto broker = new Mosquitto(directory)
                        .with(
                                "user root",
                                "persistence true",
                                "persistence_location " + kept + "/",
                                "autosave_on_changes true",
                                "autosave_interval 1")
                        .withFilesOfAtMost(8)
                        .start();
                BrokerConnection connection = reporting(address(broker))) {
            await().atMost(LIMIT).until(connection::isUp);
            String large = "x".repeat(4_000);
            for (int number = 1; number <= 5; number++) {
                connection.publish(Message.state("lamp/" + number, number + large));
            }
            await().atMost(LIMIT).until(() -> broker.logged("File too large") > 0);
            assertThat(connection.isUp()).isTrue();
            assertThat(logged.lines()).isEmpty();
            broker.stop();
            await().atMost(LIMIT).until(() -> !logged.lines().isEmpty());
            Files.deleteIfExists(kept.resolve("mosquitto.db"));
            Files.deleteIfExists(kept.resolve("mosquitto.db.new"));
            broker.withFilesOfAtMost(0).start();
            await().atMost(LIMIT).until(connection::isUp);
            try (BrokerConnection other = new BrokerConnection(address(broker), "other")) {
                Map<String, String> found =
                        retained(other, "lamp/state", "lamp/1", "lamp/2", "lamp/3", "lamp/4", "lamp/5");
                await().atMost(LIMIT).untilAsserted(() -> assertThat(found).hasSize(6));
                assertThat(found).containsEntry("lamp/state", "on").containsEntry("lamp/5", 5 + large);
            }
            assertThat(logged.lines()).doesNotHaveDuplicates();
        }
    }
}
