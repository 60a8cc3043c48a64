package org.evoloop.fleet;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import org.awaitility.Awaitility;
import org.evoloop.fleet.broker.SecureBroker;
import org.evoloop.fleet.gateway.Gateway;
import org.evoloop.fleet.stream.Fleet;
import org.evoloop.fleet.stream.FleetSettings;
import org.evoloop.fleet.stream.KafkaCluster;
import org.evoloop.fleet.wire.Topic;
import org.evoloop.mqtt.BrokerAddress;
import org.evoloop.mqtt.BrokerConnection;
import org.evoloop.mqtt.Certificate;
import org.evoloop.mqtt.Message;
import org.evoloop.mqtt.Mosquitto;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A cluster whose clients need TLS and a password, which a file of Kafka's own settings gives. */
class SecureClusterTest {
    private static final Duration LIMIT = Duration.ofMinutes(1);

    @TempDir
    private Path directory;

    private final StringWriter out = new StringWriter();
    private final StringWriter err = new StringWriter();

    private int run(String... arguments) {
        return CommandLines.run(new PrintWriter(out, true), new PrintWriter(err, true), arguments);
    }

    private String[] command(SecureBroker broker, Path settings, String... words) {
        List<String> all = new ArrayList<>(List.of(words));
        all.addAll(List.of("--bootstrap", broker.bootstrap(), "--kafka-config", settings.toString()));
        return all.toArray(String[]::new);
    }

    @Test
    void aFleetAndAGatewayConvertThere() throws Exception {
        String lamp = Path.of(System.getProperty("evoloop.root", ".."), "models", "light-bulb.xml")
                .toString();
        try (SecureBroker broker = SecureBroker.start(directory);
                Mosquitto mosquitto = new Mosquitto(directory).start()) {
            Path settings = broker.settings();
            assertThat(run(command(broker, settings, "fleet", "--create-topics", "--partitions", "1")))
                    .as(err.toString())
                    .isZero();
            assertThat(run(command(broker, settings, "fleet", "publish", "lamp-1", lamp)))
                    .isZero();
            assertThat(run(command(broker, settings, "fleet", "register", "--model", "lamp-1", "lamp")))
                    .isZero();
            KafkaCluster cluster = KafkaCluster.at(broker.bootstrap(), settings);
            FleetSettings instance = FleetSettings.defaults().withStateDirectory(directory.resolve("state"));
            List<String> commands = new CopyOnWriteArrayList<>();
            try (Fleet fleet = new Fleet(cluster, instance);
                    Gateway gateway = gateway(cluster, mosquitto);
                    BrokerConnection device = new BrokerConnection(BrokerAddress.parse(mosquitto.url()), "lamp")) {
                device.subscribe("evoloop/lamp/command", message -> commands.add(message.payload()));
                device.open();
                fleet.start();
                gateway.start();
                Awaitility.await().atMost(LIMIT).until(() -> device.isUp() && gateway.reachesDevices());
                try (Cluster topics = new Cluster(cluster, "evoloop", 1)) {
                    topics.readUntil(all -> !all.of(Topic.STATES, "lamp").isEmpty());
                }
                device.publish(
                        Message.event("evoloop/lamp/occurrence", "{\"schema\":1,\"number\":1,\"event\":\"switch\"}"));
                Awaitility.await().atMost(LIMIT).until(() -> commands.size() == 1);
                assertThat(commands.get(0)).contains("\"event\":\"switch\"");
            }
        }
    }

    private Gateway gateway(KafkaCluster cluster, Mosquitto mosquitto) {
        return new Gateway(
                cluster,
                "evoloop",
                "house",
                BrokerAddress.parse(mosquitto.url()),
                Set.of("lamp"),
                directory.resolve("journal"),
                status -> {});
    }

    @Test
    void aMistakeInTheSettingsGivesOneMessage() throws Exception {
        try (SecureBroker broker = SecureBroker.start(directory)) {
            Certificate other = Certificate.of(directory, "other", "dns:localhost");
            refused("refuses this program: Authentication failed", broker, broker.settings(store(broker), "wrong"));
            refused("refuses this program: SSL handshake failed", broker, broker.settings(other.store(), "secret"));
            refused("are wrong: there is no file", broker, broker.settings(directory.resolve("none.p12"), "secret"));
            Path file = directory.resolve("client.properties");
            refused("there is no file " + file, broker, file);
            Files.writeString(file, "security.protocl=SASL_SSL\nbootstrap.servers=x:1\nacks=1\n");
            refused("security.protocl: Kafka's clients have no such setting", broker, file);
            assertThat(err.toString()).contains("bootstrap.servers: leave it out", "acks: leave it out");
            Files.writeString(file, "security.protocol=TLS\n");
            refused("security.protocol", broker, file);
            Files.write(file, new byte[] {'a', '=', (byte) 0xff});
            refused("is not a file of properties", broker, file);
        }
    }

    private static Path store(SecureBroker broker) {
        return broker.certificate().store();
    }

    private void refused(String message, SecureBroker broker, Path settings) {
        err.getBuffer().setLength(0);
        assertThat(run(command(broker, settings, "fleet", "--create-topics")))
                .as(message)
                .isEqualTo(2);
        assertThat(err.toString())
                .startsWith("error: ")
                .contains(message)
                .doesNotContain("\tat ")
                .doesNotContain("secret");
        assertThat(out.toString()).isEmpty();
    }
}
