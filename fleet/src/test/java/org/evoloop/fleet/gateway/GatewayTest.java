package org.evoloop.fleet.gateway;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
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
import org.evoloop.fleet.stream.KafkaCluster;
import org.evoloop.fleet.wire.Topic;
import org.evoloop.fleet.wire.Wire;
import org.evoloop.mqtt.BrokerAddress;
import org.evoloop.mqtt.BrokerConnection;
import org.evoloop.mqtt.Message;
import org.evoloop.mqtt.Mosquitto;
import org.evoloop.mqtt.edge.Outbox;
import org.evoloop.payload.JsonRecord;
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
                Cluster cluster = new Cluster(KafkaCluster.at(bootstrap), FLEET, 2)) {
            cluster.write(Topic.MODELS, "lamp-1", Models.LAMP.bytes());
            cluster.flush();
            FleetSettings settings =
                    FleetSettings.defaults().withFleet(FLEET).withStateDirectory(directory.resolve("s"));
            try (Fleet fleet = new Fleet(KafkaCluster.at(bootstrap), settings);
                    Gateway gateway = gateway(bootstrap, mosquitto)) {
                fleet.start();
                assertThat(fleet.awaitRunning(LIMIT)).isTrue();
                cluster.write(Topic.DEVICES, "lamp", Wire.device("lamp-1"));
                cluster.readUntil(all -> !all.of(Topic.STATES, "lamp").isEmpty());
                gateway.start();
                Awaitility.await().atMost(LIMIT).until(gateway::reachesDevices);
                for (String level : List.of("NaN", "1e999")) {
                    lamp.publish(Message.event(
                            "evoloop/lamp/occurrence",
                            "{\"schema\":1,\"event\":\"switch\",\"values\":{\"level\":" + level + "}}"));
                }
                cluster.readUntil(all -> all.of(Topic.DEAD_LETTERS, "lamp").size() == 2);
                assertThat(cluster.records().of(Topic.DEAD_LETTERS, "lamp"))
                        .allMatch(letter -> letter.contains("\"reason\":\"malformed\""));
                press(lamp);
                cluster.readUntil(all -> all.of(Topic.DECISIONS, "lamp").size() == 1);
                assertThat(commands).hasSize(1);
                assertThat(cluster.records().of(Topic.DECISIONS, "lamp").get(0))
                        .contains("handled", "\"system\":\"on\"}}");
                // Kafka stops; two presses at the same time switch on the second light, even if they arrive later.
                broker.close();
                String pressed = "{\"schema\":1,\"event\":\"switch\",\"atMillis\":" + System.currentTimeMillis() + '}';
                lamp.publish(Message.event("evoloop/lamp/occurrence", pressed));
                lamp.publish(Message.event("evoloop/lamp/occurrence", pressed));
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
                Cluster cluster = new Cluster(KafkaCluster.at(Brokers.shared()), FLEET, 2);
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
                device.publish(Message.event(
                        "evoloop/lamp/occurrence", "{\"schema\":1," + numbers + ",\"event\":\"switch\"}"));
            }
            Awaitility.await().atMost(LIMIT).until(() -> kept.contains(kept(20)));
            assertThat(kept).containsExactly(kept(7), kept(8), kept(8), kept(12), kept(20));
            assertThat(cluster.fleet()).isEqualTo(FLEET);
        }
    }

    /** Its device keeps what the gateway does not, and repeats it. */
    @Test
    void aGatewayThatHoldsTooManyRecordsKeepsNoMoreUntilSomeAreSent() throws Exception {
        try (Outbox former = new Outbox(directory.resolve("journal"), 0)) {
            for (int waiting = 1; waiting < Gateway.MOST_WAITING; waiting++) {
                former.write(Topic.OCCURRENCES.name(), "lamp", "{}");
            }
        }
        List<String> kept = new CopyOnWriteArrayList<>();
        int port = LocalBroker.freePort();
        try (Mosquitto mosquitto = new Mosquitto(directory).start();
                BrokerConnection device = new BrokerConnection(BrokerAddress.parse(mosquitto.url()), "device");
                Gateway gateway = gateway("127.0.0.1:" + port, mosquitto)) {
            device.subscribe("evoloop/lamp/kept", message -> kept.add(message.payload()));
            device.open();
            gateway.start();
            Awaitility.await().atMost(LIMIT).until(() -> device.isUp() && gateway.reachesDevices());
            numbered(device, 1);
            numbered(device, 2);
            Awaitility.await().atMost(LIMIT).until(() -> last(statuses).contains("records are no longer stored"));
            assertThat(gateway.waiting()).isEqualTo(Gateway.MOST_WAITING);

            try (LocalBroker broker = LocalBroker.start(directory.resolve("kafka"), port, LocalBroker.freePort());
                    Cluster cluster = new Cluster(KafkaCluster.at(broker.bootstrap()), FLEET, 1)) {
                Awaitility.await().atMost(LIMIT).until(() -> gateway.waiting() == 0);
                numbered(device, 2);
                Awaitility.await().atMost(LIMIT).until(() -> kept.contains(kept(2)));
                assertThat(kept).containsExactly(kept(1), kept(2));
                assertThat(cluster.fleet()).isEqualTo(FLEET);
            }
        }
    }

    private static void numbered(BrokerConnection device, int number) {
        device.publish(Message.event(
                "evoloop/lamp/occurrence",
                "{\"schema\":1,\"number\":" + number + ",\"first\":" + number + ",\"event\":\"switch\"}"));
    }

    /** Otherwise the fleet would take its records for repetitions. */
    @Test
    void aGatewayThatLostItsJournalIsHeard() throws Exception {
        String name = Brokers.freshFleet();
        FleetSettings settings = FleetSettings.defaults().withFleet(name).withStateDirectory(directory.resolve("s"));
        try (Mosquitto mosquitto = new Mosquitto(directory).start();
                BrokerConnection lamp = lamp(mosquitto);
                Cluster cluster = new Cluster(KafkaCluster.at(Brokers.shared()), name, 1)) {
            cluster.write(Topic.MODELS, "lamp-1", Models.LAMP.bytes());
            cluster.flush();
            try (Fleet fleet = new Fleet(KafkaCluster.at(Brokers.shared()), settings)) {
                fleet.start();
                assertThat(fleet.awaitRunning(LIMIT)).isTrue();
                cluster.write(Topic.DEVICES, "lamp", Wire.device("lamp-1"));
                cluster.readUntil(all -> !all.of(Topic.STATES, "lamp").isEmpty());
                for (int life = 1; life <= 2; life++) {
                    int presses = life;
                    try (Gateway gateway = gateway(name, mosquitto, Set.of("lamp"), "journal " + life)) {
                        gateway.start();
                        Awaitility.await().atMost(LIMIT).until(gateway::reachesDevices);
                        press(lamp);
                        cluster.readUntil(all -> all.of(Topic.DECISIONS, "lamp").size() == presses);
                    }
                }
            }
        }
    }

    /** The state is retained at the broker, so a device that connects later gets it, too. */
    @Test
    void aDeviceThatIsNewAtTheGatewayGetsItsState() throws Exception {
        String name = Brokers.freshFleet();
        List<String> states = new CopyOnWriteArrayList<>();
        try (Mosquitto mosquitto = new Mosquitto(directory).start();
                BrokerConnection watcher = new BrokerConnection(BrokerAddress.parse(mosquitto.url()), "watcher");
                Cluster cluster = new Cluster(KafkaCluster.at(Brokers.shared()), name, 1)) {
            watcher.subscribe("evoloop/hall/state", message -> states.add(message.payload()));
            watcher.subscribe("evoloop/lamp/state", message -> states.add(message.payload()));
            watcher.open();
            Awaitility.await().atMost(LIMIT).until(watcher::isUp);
            state(cluster, "lamp", "former");
            state(cluster, "lamp", "1");
            state(cluster, "hall", "2");
            try (Gateway gateway = gateway(name, mosquitto, Set.of("hall"), "journal")) {
                gateway.start();
                Awaitility.await().atMost(LIMIT).until(() -> states.contains("2"));
                // What was read before the next record is committed when this one is there.
                state(cluster, "hall", "3");
                Awaitility.await().atMost(LIMIT).until(() -> states.contains("3"));
                mosquitto.stop();
                Awaitility.await().atMost(LIMIT).until(() -> last(statuses).contains(mosquitto.url() + " "));
                mosquitto.start();
                Awaitility.await()
                        .atMost(LIMIT)
                        .until(() -> last(statuses).contains("MQTT: the devices' broker can be reached"));
                assertThat(statuses).allMatch(status -> status.contains("Kafka can be reached"));
            }
            states.clear();
            try (Gateway gateway = gateway(name, mosquitto, Set.of("hall", "lamp"), "journal")) {
                gateway.start();
                Awaitility.await().atMost(LIMIT).until(() -> states.contains("1"));
            }
            assertThat(states).doesNotContain("former");
        }
    }

    /** It comes again whenever the gateway connects. */
    @Test
    void aRetainedRecordWithoutANumberIsIgnored() throws Exception {
        List<String> kept = new CopyOnWriteArrayList<>();
        try (Mosquitto mosquitto = new Mosquitto(directory).start();
                BrokerConnection device = new BrokerConnection(BrokerAddress.parse(mosquitto.url()), "device");
                // It does not reach Kafka, so what it stores is counted.
                Gateway gateway = gateway("localhost:1", FLEET, mosquitto, Set.of("a", "b"), "journal")) {
            device.subscribe("evoloop/b/kept", message -> kept.add(message.payload()));
            device.open();
            device.publish(Message.state("evoloop/a/occurrence", "{\"schema\":1,\"event\":\"switch\"}"));
            device.publish(Message.state("evoloop/b/occurrence", "{\"schema\":1,\"event\":\"switch\",\"number\":7}"));
            device.publish(Message.state("evoloop/b/end", "there"));
            try (BrokerConnection later = new BrokerConnection(BrokerAddress.parse(mosquitto.url()), "later")) {
                List<String> ends = new CopyOnWriteArrayList<>();
                later.subscribe("evoloop/b/end", message -> ends.add(message.payload()));
                later.open();
                Awaitility.await().atMost(LIMIT).until(() -> !ends.isEmpty());
            }
            gateway.start();
            // From then on it has got what was retained.
            Awaitility.await().atMost(LIMIT).until(() -> gateway.reachesDevices() && device.isUp());
            device.publish(Message.event("evoloop/b/occurrence", "{\"schema\":1,\"event\":\"switch\",\"number\":8}"));
            Awaitility.await().atMost(LIMIT).until(() -> kept.contains(kept(8)));
            assertThat(gateway.waiting()).isEqualTo(2);
        }
    }

    /** Wherever else that name or text is in the record: its time is a member of the record itself. */
    @Test
    void aRecordWithoutATimeGetsOne() throws Exception {
        List<String> kept = new CopyOnWriteArrayList<>();
        try (Mosquitto mosquitto = new Mosquitto(directory).start();
                BrokerConnection device = new BrokerConnection(BrokerAddress.parse(mosquitto.url()), "device");
                // It does not reach Kafka, so what it stores stays.
                Gateway gateway = gateway("localhost:1", FLEET, mosquitto, Set.of("lamp"), "journal")) {
            device.subscribe("evoloop/lamp/kept", message -> kept.add(message.payload()));
            device.open();
            gateway.start();
            Awaitility.await().atMost(LIMIT).until(() -> device.isUp() && gateway.reachesDevices());
            for (String members : List.of(
                    ",\"values\":{\"name\":\"atMillis\"}",
                    ",\"values\":{\"atMillis\":\"7\"}",
                    ",\"holding\":[\"atMillis\"]",
                    "",
                    ",\"at\\u004dillis\":9",
                    ",\"atMillis\":9")) {
                device.publish(Message.event(
                        "evoloop/lamp/occurrence", "{ \"schema\":1,\"event\":\"switch\"" + members + "}"));
            }
            device.publish(Message.event("evoloop/lamp/occurrence", "{}"));
            device.publish(Message.event("evoloop/lamp/occurrence", "{\"schema\":1,\"number\":7}"));
            Awaitility.await().atMost(LIMIT).until(() -> kept.contains(kept(7)));
        }
        try (Outbox stored = new Outbox(directory.resolve("journal"), 0)) {
            List<Long> times = stored.first(9, 0).stream()
                    .map(entry -> JsonRecord.of(entry.record()).number("atMillis"))
                    .toList();
            assertThat(times).hasSize(8);
            assertThat(times.subList(4, 6)).containsOnly(9L);
            assertThat(times.subList(0, 4)).allMatch(time -> time > 1_000);
            assertThat(times.subList(6, 8)).allMatch(time -> time > 1_000);
        }
    }

    private static void state(Cluster cluster, String device, String state) {
        cluster.write(Topic.STATES, device, state.getBytes(StandardCharsets.UTF_8));
        cluster.flush();
    }

    private static String last(List<String> texts) {
        return texts.isEmpty() ? "" : texts.get(texts.size() - 1);
    }

    private static String kept(int number) {
        return "{\"schema\":1,\"number\":" + number + "}";
    }

    private Gateway gateway(String bootstrap, Mosquitto mosquitto) {
        return gateway(bootstrap, FLEET, mosquitto, Set.of("lamp"), "journal");
    }

    private Gateway gateway(String fleet, Mosquitto mosquitto, Set<String> devices, String journal) throws IOException {
        return gateway(Brokers.shared(), fleet, mosquitto, devices, journal);
    }

    private Gateway gateway(String bootstrap, String fleet, Mosquitto mosquitto, Set<String> devices, String journal) {
        BrokerAddress address = BrokerAddress.parse(mosquitto.url());
        return new Gateway(
                KafkaCluster.at(bootstrap),
                fleet,
                "house",
                address,
                devices,
                directory.resolve(journal),
                statuses::add);
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
