package org.evoloop.mqtt;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;

import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.time.Duration;
import java.util.Base64;
import java.util.HexFormat;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.evoloop.Logged;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** With Debian's Mosquitto. */
class BrokerConnectionTest {
    private static final Duration LIMIT = Duration.ofSeconds(30);

    @TempDir
    private Path directory;

    private final Logged logged = new Logged("org.evoloop.mqtt");

    @AfterEach
    void endLog() {
        logged.close();
    }

    private static BrokerConnection connection(String url) {
        return new BrokerConnection(BrokerAddress.parse(url), "test");
    }

    @Test
    void statesSurviveARestartOfABrokerThatForgetsEverything() throws Exception {
        try (Mosquitto broker = new Mosquitto(directory).start();
                BrokerConnection connection = connection(broker.url())) {
            connection.open();
            connection.publish(Message.state("lamp/state", "on"));
            for (int restart = 1; restart <= 3; restart++) {
                await().atMost(LIMIT).until(connection::isUp);
                broker.stop();
                await().atMost(LIMIT).until(() -> connection.downSince().isPresent());
                connection.publish(Message.state("lamp/power", "level " + restart));
                broker.start();
                try (Watcher watcher = new Watcher(broker)) {
                    watcher.awaitNewest("lamp/state", "on");
                    watcher.awaitNewest("lamp/power", "level " + restart);
                }
            }
            assertThat(connection.connects()).isEqualTo(4);
        }
    }

    @Test
    void aConnectionOnWhichNothingIsPublishedSaysThatItIsThere() throws Exception {
        try (Mosquitto broker = new Mosquitto(directory).start();
                BrokerConnection connection = connection(broker.url())) {
            assertThat(connection.describe()).isEqualTo(broker.url() + " has not been reached yet");
            connection.subscribe("lamp/button", message -> {});
            connection.open();
            for (int restart = 0; restart < 2; restart++) {
                await().atMost(LIMIT).until(connection::isUp);
                assertThat(connection.describe()).isEqualTo(broker.url());
                broker.stop();
                await().atMost(LIMIT).until(() -> !connection.isUp());
                assertThat(connection.describe()).startsWith(broker.url()).isNotEqualTo(broker.url());
                broker.start();
            }
        }
    }

    @Test
    void whoeverWaitsForRoomLosesNothing() throws Exception {
        List<String> heard = new CopyOnWriteArrayList<>();
        try (Mosquitto broker = new Mosquitto(directory).start();
                BrokerConnection connection = connection(broker.url());
                BrokerConnection other = new BrokerConnection(BrokerAddress.parse(broker.url()), "other")) {
            other.subscribe("lamp/set", message -> heard.add(message.payload()));
            other.open();
            connection.open();
            await().atMost(LIMIT).until(() -> connection.isUp() && other.isUp());
            for (int each = 0; each < 1_000; each++) {
                connection.awaitRoom();
                connection.publish(Message.command("lamp/set", String.valueOf(each)));
            }
            await().atMost(LIMIT).until(() -> heard.size() == 1_000);
            assertThat(connection.lost()).isZero();
        }
    }

    @Test
    void eventsOfAnOutageAreReportedAfterwardsAndCommandsAreNot() throws Exception {
        try (Mosquitto broker = new Mosquitto(directory);
                BrokerConnection connection = connection(broker.url())) {
            connection.open();
            connection.publish(Message.command("lamp/set", "toggle"));
            connection.publish(Message.event("lamp/event", "pressed"));
            connection.publish(Message.state("lamp/end", "yes"));
            List<String> heard = new CopyOnWriteArrayList<>();
            broker.start();
            try (BrokerConnection other = connection(broker.url() + "?id=x")) {
                other.subscribe("lamp/event", message -> heard.add(message.payload()));
                other.subscribe("lamp/set", message -> heard.add(message.payload()));
                other.open();
                await().atMost(LIMIT).until(() -> connection.isUp() || other.isUp());
            }
            try (Watcher watcher = new Watcher(broker)) {
                watcher.awaitNewest("lamp/end", "yes");
            }
            assertThat(heard).doesNotContain("toggle");
        }
    }

    @Test
    void theWillReportsThatAClientIsGone() throws Exception {
        try (Mosquitto broker = new Mosquitto(directory).start();
                Watcher watcher = new Watcher(broker);
                BrokerConnection connection = connection(broker.url())) {
            connection.will(Message.state("lamp/availability", "offline"));
            connection.publish(Message.state("lamp/availability", "online"));
            connection.open();
            watcher.awaitNewest("lamp/availability", "online");
            try (BrokerConnection usurper = connection(broker.url())) {
                usurper.open();
                watcher.awaitHeard("lamp/availability", "offline");
                await().atMost(LIMIT)
                        .untilAsserted(() -> assertThat(logged.lines()).anyMatch(line -> line.contains("?id=ID")));
            }
        }
    }

    @Test
    void aWrongPasswordIsSaidOnceHoweverOftenItIsTried() throws Exception {
        Path passwords = directory.resolve("passwords");
        Files.createFile(passwords);
        assertThat(new ProcessBuilder(Mosquitto.program("mosquitto_passwd"), "-b", passwords.toString(), "ha", "right")
                        .inheritIO()
                        .start()
                        .waitFor())
                .isZero();
        try (Mosquitto broker = new Mosquitto(directory)
                        .with("user root", "allow_anonymous false", "password_file " + passwords)
                        .start();
                BrokerConnection wrong = new BrokerConnection(
                        BrokerAddress.parse("mqtt://ha@127.0.0.1:" + broker.port())
                                .withPassword("wr0ng"),
                        "wrong");
                BrokerConnection right = new BrokerConnection(
                        BrokerAddress.parse("mqtt://ha@127.0.0.1:" + broker.port())
                                .withPassword("right"),
                        "right")) {
            wrong.open();
            Path log = directory.resolve("mosquitto-" + broker.port() + ".log");
            await().atMost(LIMIT)
                    .until(() -> Files.readAllLines(log).stream()
                                    .filter(line -> line.contains("not authori"))
                                    .count()
                            >= 3);
            assertThat(logged.lines()).hasSize(1);
            assertThat(logged.lines().get(0))
                    .contains("refuses the login of user ha", MqttOptions.PASSWORD.variable())
                    .doesNotContain("wr0ng");
            assertThat(wrong.describe()).isEqualTo(logged.lines().get(0).split("; trying to connect again")[0]);
            right.open();
            await().atMost(LIMIT).until(right::isUp);
        }
    }

    @Test
    void onlyABrokerWhoseCertificateIsTrustedGetsThePassword() throws Exception {
        Certificate own = Certificate.of(directory, "own", "ip:127.0.0.1");
        Certificate foreign = Certificate.of(directory, "foreign", "ip:127.0.0.1");
        Certificate misnamed = Certificate.of(directory, "misnamed", "dns:elsewhere");
        assertThat(trouble(own, foreign.certificate())).contains("certificate is not trusted", "?ca=FILE");
        assertThat(trouble(misnamed, misnamed.certificate())).contains("certificate is not trusted", "127.0.0.1");
        assertThat(trouble(own, own.certificate())).isEmpty();
    }

    @Test
    void aSelfSignedCertificateIsTrustedOnlyIfItIsPinned() throws Exception {
        Certificate own = Certificate.of(directory, "own", "dns:elsewhere");
        Certificate foreign = Certificate.of(directory, "foreign", "ip:127.0.0.1");
        assertThat(trouble(own, "sha256=" + fingerprint(own))).isEmpty();
        assertThat(trouble(foreign, "sha256=" + fingerprint(own)))
                .contains("certificate is not trusted", "sha256 is " + fingerprint(foreign));
        assertThat(trouble(own, "sha256=ask"))
                .contains("nobody has confirmed it yet", "openssl s_client", "write sha256=" + fingerprint(own));
        assertThat(trouble(own, "id=x")).contains("certificate is not trusted", "?sha256=FINGERPRINT");
    }

    private static String fingerprint(Certificate certificate) throws Exception {
        byte[] encoded = Base64.getMimeDecoder()
                .decode(Files.readString(certificate.certificate()).replaceAll("-----.*?-----", ""));
        return HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(encoded));
    }

    @Test
    @Timeout(value = 60, threadMode = Timeout.ThreadMode.SEPARATE_THREAD) // opening a pipe cannot be interrupted
    void certificatesAreReadOnceSinceTheyMayComeFromAPipe() throws Exception {
        Path pipe = directory.resolve("pipe");
        assertThat(new ProcessBuilder("mkfifo", pipe.toString()).start().waitFor())
                .isZero();
        Path certificate = Certificate.of(directory, "own", "ip:127.0.0.1").certificate();
        new ProcessBuilder("cp", certificate.toString(), pipe.toString()).start();
        BrokerAddress address = BrokerAddress.parse("mqtts://ha@b?ca=" + pipe);
        assertThat(address.withPassword("right").trust()).isNotNull().isSameAs(address.trust());
    }

    /** The error for a broker that presents one certificate if the client trusts another. */
    private String trouble(Certificate shown, Path trusted) {
        return trouble(shown, "ca=" + trusted);
    }

    /** @param trust what follows the question mark of the URL */
    private String trouble(Certificate shown, String trust) {
        try (Mosquitto broker = new Mosquitto(directory)
                        .with("user root", "certfile " + shown.certificate(), "keyfile " + shown.key())
                        .start();
                BrokerConnection connection = connection("mqtts://127.0.0.1:" + broker.port() + "?" + trust)) {
            int before = logged.lines().size();
            connection.publish(Message.state("a", "b"));
            connection.open();
            await().atMost(LIMIT)
                    .until(() -> connection.describe().startsWith("mqtts://127.0.0.1:" + broker.port())
                            && (connection.connects() > 0 && connection.isUp()
                                    || logged.lines().size() > before));
            return connection.isUp() ? "" : logged.lines().get(before);
        }
    }

    @Test
    void aBrokerWithoutTlsIsNotSpokenToInClear() throws Exception {
        try (Mosquitto broker = new Mosquitto(directory).start();
                BrokerConnection connection = connection("mqtts://127.0.0.1:" + broker.port())) {
            connection.open();
            await().atMost(LIMIT).until(() -> !logged.lines().isEmpty());
            assertThat(connection.isUp()).isFalse();
        }
    }

    @Test
    void certificatesThatCannotBeReadAreRefusedAtOnce() throws Exception {
        assertThatThrownBy(() -> connection("mqtts://b?ca=/no/such"))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("/no/such");
        Path empty = Files.writeString(directory.resolve("empty.pem"), "nothing\n");
        assertThatThrownBy(() -> connection("mqtts://b?ca=" + empty))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("PEM");
    }

    @Test
    void whatTheBrokerForbidsIsSaidOnceAndTheRestIsPublished() throws Exception {
        Path acl = Files.writeString(directory.resolve("acl"), "topic read #\ntopic write allowed\n");
        try (Mosquitto broker = new Mosquitto(directory)
                        .with("user root", "acl_file " + acl)
                        .start();
                Watcher watcher = new Watcher(broker);
                BrokerConnection connection = connection(broker.url())) {
            connection.publish(Message.state("forbidden", "1"));
            connection.publish(Message.state("allowed", "1"));
            connection.open();
            watcher.awaitNewest("allowed", "1");
            connection.publish(Message.state("forbidden", "2"));
            connection.publish(Message.state("allowed", "2"));
            watcher.awaitNewest("allowed", "2");
            assertThat(logged.lines()).hasSize(1).allMatch(line -> line.contains("forbidden"));
        }
    }

    @Test
    void aConsumerThatThrowsDoesNotAffectOthersAndIsLoggedOnce() throws Exception {
        List<String> heard = new CopyOnWriteArrayList<>();
        try (Mosquitto broker = new Mosquitto(directory).start();
                Watcher watcher = new Watcher(broker);
                BrokerConnection connection = connection(broker.url())) {
            connection.subscribe("bad", message -> {
                throw new IllegalStateException("it is bad");
            });
            connection.subscribe("good", message -> heard.add(message.payload()));
            connection.open();
            await().atMost(LIMIT).until(connection::isUp);
            watcher.publish("bad", "1", false);
            watcher.publish("bad", "2", false);
            watcher.publish("good", "3", false);
            await().atMost(LIMIT).until(() -> heard.contains("3"));
            assertThat(logged.lines())
                    .hasSize(1)
                    .allMatch(line -> line.contains("a message on bad could not be handled"));
        }
    }

    @Test
    void aMissingBrokerDelaysNothing() {
        try (BrokerConnection connection = connection("mqtt://127.0.0.1:1")) {
            connection.open();
            connection.publish(Message.state("a", "b"));
            await().atMost(LIMIT).until(() -> !logged.lines().isEmpty());
            assertThat(connection.describe()).contains("cannot be reached");
        }
        assertThat(logged.lines()).hasSize(1);
    }
}
