package org.evoloop.fleet;

import static org.assertj.core.api.Assertions.assertThat;

import io.micrometer.core.instrument.simple.SimpleMeterRegistry;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Set;
import org.awaitility.Awaitility;
import org.evoloop.fleet.broker.LocalBroker;
import org.evoloop.fleet.gateway.Gateway;
import org.evoloop.fleet.stream.Fleet;
import org.evoloop.fleet.stream.FleetSettings;
import org.evoloop.fleet.stream.KafkaCluster;
import org.evoloop.fleet.wire.Topic;
import org.evoloop.mqtt.BrokerAddress;
import org.evoloop.mqtt.BrokerConnection;
import org.evoloop.mqtt.Message;
import org.evoloop.mqtt.Mosquitto;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What instances and gateways tell of themselves. */
class ObservedTest {
    private static final Duration LIMIT = Duration.ofMinutes(1);

    @TempDir
    private Path directory;

    @Test
    void anInstanceCountsAndNoticesThatTheBrokerIsGone() throws Exception {
        try (LocalBroker broker = LocalBroker.start(directory.resolve("kafka"))) {
            KafkaCluster kafka = KafkaCluster.at(broker.bootstrap());
            FleetSettings settings = FleetSettings.defaults()
                    .withSession(Duration.ofSeconds(2))
                    .withStateDirectory(directory.resolve("state"));
            SimpleMeterRegistry registry = new SimpleMeterRegistry();
            try (Cluster cluster = new Cluster(kafka, "evoloop", 1);
                    Fleet fleet = new Fleet(kafka, settings)) {
                fleet.metrics().bindTo(registry);
                assertThat(fleet.isRunning()).isFalse();
                assertThat(fleet.describe()).isEqualTo("the instance is created; no broker of Kafka is reached");
                fleet.start();
                assertThat(fleet.awaitRunning(LIMIT)).isTrue();
                cluster.write(Topic.OCCURRENCES, "lamp", "{}".getBytes(StandardCharsets.UTF_8));
                cluster.readUntil(all -> all.of(Topic.DEAD_LETTERS).size() == 1);
                assertThat(registry.get("evoloop.fleet.dead.letters")
                                .tag("reason", "malformed")
                                .functionCounter()
                                .count())
                        .isEqualTo(1);
                assertThat(registry.getMeters())
                        .anyMatch(meter -> meter.getId().getName().startsWith("kafka."));
                Awaitility.await().atMost(LIMIT).until(() -> fleet.isRunning() && fleet.reachesKafka());
                assertThat(fleet.describe()).isEqualTo("the instance is running");
                broker.close();
                Awaitility.await().atMost(LIMIT).until(() -> !fleet.reachesKafka());
            }
        }
    }

    @Test
    void aGatewayCountsAndNoticesThatABrokerIsGone() throws Exception {
        try (LocalBroker broker = LocalBroker.start(directory.resolve("kafka"));
                Mosquitto mosquitto = new Mosquitto(directory).start();
                Cluster cluster = new Cluster(KafkaCluster.at(broker.bootstrap()), "evoloop", 1);
                Gateway gateway = new Gateway(
                        KafkaCluster.at(broker.bootstrap()),
                        cluster.fleet(),
                        "house",
                        BrokerAddress.parse(mosquitto.url()),
                        Set.of("lamp"),
                        directory.resolve("journal"),
                        status -> {});
                BrokerConnection device = new BrokerConnection(BrokerAddress.parse(mosquitto.url()), "lamp")) {
            SimpleMeterRegistry registry = new SimpleMeterRegistry();
            gateway.metrics().bindTo(registry);
            assertThat(gateway.describe()).startsWith("Kafka is not reached yet; records waiting: 0; MQTT: ");
            gateway.start();
            device.open();
            Awaitility.await()
                    .atMost(LIMIT)
                    .until(() -> device.isUp() && gateway.reachesDevices() && gateway.reachesKafka());
            device.publish(Message.event("evoloop/lamp/occurrence", "{\"schema\":1,\"event\":\"switch\"}"));
            Awaitility.await()
                    .atMost(LIMIT)
                    .until(() -> registry.get("evoloop.gateway.records")
                                    .tag("step", "sent")
                                    .functionCounter()
                                    .count()
                            == 1);
            assertThat(registry.get("evoloop.gateway.kafka.up").gauge().value()).isEqualTo(1);
            assertThat(gateway.describe())
                    .isEqualTo("Kafka can be reached; records waiting: 0; MQTT: the devices' broker can be reached");
            broker.close();
            device.publish(Message.event("evoloop/lamp/occurrence", "{\"schema\":1,\"event\":\"switch\"}"));
            Awaitility.await().atMost(LIMIT).until(() -> !gateway.reachesKafka());
            assertThat(gateway.describe()).startsWith("Kafka is not reached; the devices' records are stored");
        }
    }
}
