package org.evoloop.fleet.gateway;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import org.awaitility.Awaitility;
import org.evoloop.fleet.Brokers;
import org.evoloop.fleet.Cluster;
import org.evoloop.fleet.Models;
import org.evoloop.fleet.broker.LocalBroker;
import org.evoloop.fleet.stream.Fleet;
import org.evoloop.fleet.stream.FleetSettings;
import org.evoloop.fleet.wire.Topic;
import org.evoloop.fleet.wire.Wire;
import org.evoloop.mqtt.BrokerAddress;
import org.evoloop.mqtt.BrokerConnection;
import org.evoloop.mqtt.Message;
import org.evoloop.mqtt.Mosquitto;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A lamp at a real MQTT broker, in a fleet at a real Kafka broker. */
class GatewayTest {
    private static final String FLEET = "bridged";
    private static final Duration LIMIT = Duration.ofSeconds(90);

    @TempDir
    private Path directory;

    private final List<String> commands = new CopyOnWriteArrayList<>();
    private final List<String> statuses = new CopyOnWriteArrayList<>();

    @Test
    void recordsOfTheLampAreStoredWhileKafkaIsUnavailableAndSentInOrder() throws Exception {
        int port = LocalBroker.freePort();
        int controller = LocalBroker.freePort();
        Path kafka = directory.resolve("kafka");
        LocalBroker broker = LocalBroker.start(kafka, port, controller);
        String bootstrap = broker.bootstrap();
        try (Mosquitto mosquitto = new Mosquitto(directory).start();
                BrokerConnection lamp = lamp(mosquitto);
                Cluster cluster = new Cluster(bootstrap, FLEET, 2)) {
            cluster.write(Topic.MODELS, "lamp-1", Models.LAMP.bytes());
            cluster.flush();
            FleetSettings settings =
                    FleetSettings.defaults().withFleet(FLEET).withStateDirectory(directory.resolve("s"));
            try (Fleet fleet = new Fleet(bootstrap, settings);
                    Gateway gateway = gateway(bootstrap, mosquitto)) {
                fleet.start();
                assertThat(fleet.awaitRunning(LIMIT)).isTrue();
                cluster.write(Topic.DEVICES, "lamp", Wire.device("lamp-1"));
                cluster.readUntil(all -> !all.of(Topic.STATES, "lamp").isEmpty());
                gateway.start();
                Awaitility.await().atMost(LIMIT).until(gateway::reachesDevices);
                for (String level : List.of("NaN", "1e999")) {
                    lamp.publish(Message.event(
                            "evoloop/lamp/occurrence", "{\"event\":\"switch\",\"values\":{\"level\":" + level + "}}"));
                }
                cluster.readUntil(all -> all.of(Topic.DEAD_LETTERS, "lamp").size() == 2);
                assertThat(cluster.records().of(Topic.DEAD_LETTERS, "lamp"))
                        .allMatch(letter -> letter.contains("\"reason\":\"malformed\""));
                press(lamp);
                cluster.readUntil(all -> all.of(Topic.DECISIONS, "lamp").size() == 1);
                assertThat(commands).hasSize(1);
                assertThat(cluster.records().of(Topic.DECISIONS, "lamp").get(0))
                        .contains("handled", "\"system\":\"on\"}}");
                // Kafka stops; two presses within two seconds switch on the second light, even if they arrive later.
                broker.close();
                press(lamp);
                press(lamp);
                Awaitility.await().atMost(LIMIT).until(() -> gateway.waiting() == 2);
                broker = LocalBroker.start(kafka, port, controller);
                cluster.readUntil(all -> all.of(Topic.DECISIONS, "lamp").size() == 3);
                assertThat(cluster.records().of(Topic.DECISIONS, "lamp").get(2)).contains("incandescentOn");
                Awaitility.await().atMost(LIMIT).until(() -> gateway.waiting() == 0);
                assertThat(commands).hasSize(1);
                assertThat(statuses.get(0)).contains("Kafka can be reached");
            }
        } finally {
            broker.close();
        }
    }

    /** What was published before the gateway had subscribed is lost; its device publishes it again. */
    @Test
    void aRecordIsNotStoredBeforeThoseThatItsDevicePublishedEarlier() throws Exception {
        List<String> kept = new CopyOnWriteArrayList<>();
        try (Mosquitto mosquitto = new Mosquitto(directory).start();
                BrokerConnection device =
                        new BrokerConnection(BrokerAddress.parse("mqtt://127.0.0.1:" + mosquitto.port()), "device");
                Cluster cluster = new Cluster(Brokers.shared(), FLEET, 2);
                Gateway gateway = gateway(Brokers.shared(), mosquitto)) {
            device.subscribe("evoloop/lamp/kept", message -> kept.add(message.payload()));
            device.open();
            gateway.start();
            Awaitility.await().atMost(LIMIT).until(() -> device.isUp() && gateway.reachesDevices());
            for (String numbers : List.of(
                    "\"number\":8,\"first\":7",
                    "\"number\":7,\"first\":7",
                    "\"number\":8,\"first\":7",
                    "\"number\":8,\"first\":7",
                    "\"number\":12,\"first\":12",
                    "\"number\":14,\"first\":12",
                    "\"number\":20")) {
                device.publish(Message.event("evoloop/lamp/occurrence", "{" + numbers + ",\"event\":\"switch\"}"));
            }
            Awaitility.await().atMost(LIMIT).until(() -> kept.contains(kept(20)));
            assertThat(kept).containsExactly(kept(7), kept(8), kept(8), kept(12), kept(20));
            assertThat(cluster.fleet()).isEqualTo(FLEET);
        }
    }

    private static String kept(int number) {
        return "{\"schema\":1,\"number\":" + number + "}";
    }

    private Gateway gateway(String bootstrap, Mosquitto mosquitto) {
        BrokerAddress address = BrokerAddress.parse("mqtt://127.0.0.1:" + mosquitto.port());
        return new Gateway(
                bootstrap, FLEET, "house", address, Set.of("lamp"), directory.resolve("journal"), statuses::add);
    }

    /** Carries out each command, and reports it. */
    private BrokerConnection lamp(Mosquitto mosquitto) {
        BrokerConnection lamp =
                new BrokerConnection(BrokerAddress.parse("mqtt://127.0.0.1:" + mosquitto.port()), "the-lamp");
        lamp.subscribe("evoloop/lamp/command", command -> {
            commands.add(command.payload());
            lamp.publish(Message.event(
                    "evoloop/lamp/effect", "{\"schema\":1,\"sequence\":" + commands.size() + ",\"outcome\":\"sent\"}"));
        });
        lamp.open();
        Awaitility.await().atMost(LIMIT).until(lamp::isUp);
        return lamp;
    }

    private static void press(BrokerConnection lamp) {
        lamp.publish(Message.event("evoloop/lamp/occurrence", "{\"schema\":1,\"event\":\"switch\"}"));
    }
}
