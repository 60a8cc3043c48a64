package org.evoloop.fleet;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.apache.kafka.clients.admin.Admin;
import org.apache.kafka.common.config.ConfigResource;
import org.awaitility.Awaitility;
import org.evoloop.fleet.stream.Fleet;
import org.evoloop.fleet.stream.FleetSettings;
import org.evoloop.fleet.stream.KafkaCluster;
import org.evoloop.fleet.stream.TopicSettings;
import org.evoloop.fleet.wire.Topic;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A mistake on the command line gives one message, and exit status 2. */
class FleetCommandTest {
    @TempDir
    private Path directory;

    private final StringWriter out = new StringWriter();
    private final StringWriter err = new StringWriter();

    private int run(String... arguments) {
        return CommandLines.run(new PrintWriter(out, true), new PrintWriter(err, true), arguments);
    }

    @Test
    void mistakesGiveOneMessage() throws Exception {
        mistake("give --bootstrap HOST:PORT, or --demo", "fleet");
        mistake("--devices is 0, allowed is 1 to 1000000", "fleet", "--demo", "--devices", "0");
        mistake("--partitions is for --create-topics", "fleet", "--bootstrap", "localhost:1", "--partitions", "3");
        mistake("a device's id is empty", "fleet", "register", "--bootstrap", "localhost:1", "--model", "m", "a", "");
        mistake("the rollout's name is empty", rollout(new String[] {"--bootstrap", "localhost:1"}, "", "1", "2"));
        mistake("--devices is for --demo", "fleet", "--bootstrap", "localhost:1", "--devices", "3");
        mistake("'nowhere' is not the address of a Kafka broker", "fleet", "--bootstrap", "nowhere");
        mistake("the fleet's name is 'a b'", "fleet", "--bootstrap", Brokers.shared(), "--name", "a b");
        mistake("threads is 0, allowed is 1 to 1000", "fleet", "--bootstrap", Brokers.shared(), "--threads", "0");
        mistake("standbys is -1", "fleet", "--bootstrap", Brokers.shared(), "--standbys", "-1");
        mistake("the commit interval is PT0S", "fleet", "--bootstrap", Brokers.shared(), "--commit-ms", "0");
        mistake("the session timeout is 3 ms", "fleet", "--bootstrap", Brokers.shared(), "--session-ms", "3");
        mistake("--partitions is 0", "fleet", "--bootstrap", Brokers.shared(), "--create-topics", "--partitions", "0");
        mistake("the device is 'a/b'", gateway("a/b", "j"));
        String many = IntStream.rangeClosed(1, 501).mapToObj(String::valueOf).collect(Collectors.joining(","));
        mistake("--device names 501 devices, and a gateway takes 500 at most", gateway(many, "j"));
        mistake("none.occurrences is missing", "fleet", "--bootstrap", Brokers.shared(), "--name", "none");
    }

    private static String[] gateway(String devices, String journal) throws IOException {
        return new String[] {
            "gateway", "--bootstrap", Brokers.shared(), "--mqtt", "mqtt://h", "--device", devices, "--journal", journal
        };
    }

    private void mistake(String message, String... arguments) {
        err.getBuffer().setLength(0);
        assertThat(run(arguments)).as(message).isEqualTo(2);
        assertThat(err.toString()).startsWith("error: ").contains(message).doesNotContain("\tat ");
        assertThat(out.toString()).isEmpty();
    }

    @Test
    void aGatewayRefusesAJournalThatItCannotWrite() throws Exception {
        assertThat(run("fleet", "--bootstrap", Brokers.shared(), "--create-topics", "--partitions", "1"))
                .isZero();
        out.getBuffer().setLength(0);
        mistake("--journal: /dev/null/j cannot be used", gateway("a", "/dev/null/j"));
    }

    @Test
    void programsThatAreAskedToEndHaveStatusZero() throws Exception {
        String[] cluster = {"--bootstrap", Brokers.shared(), "--name", Brokers.freshFleet()};
        assertThat(run(with(cluster, "fleet", "--create-topics", "--partitions", "1")))
                .isZero();
        String state = directory.resolve("state").toString();
        ends("an instance of the fleet '" + cluster[3] + "' runs", with(cluster, "fleet", "--state-dir", state));
        String journal = directory.resolve("journal").toString();
        ends(
                "Kafka can be reached",
                with(cluster, "gateway", "--mqtt", "mqtt://localhost:1", "--device", "a", "--journal", journal));
        // It has run before, so it stores records until Kafka is back. A wrong address is found out at the first start.
        String[] unreachable = {"--bootstrap", "localhost:1", "--mqtt", "mqtt://localhost:1", "--device", "a"};
        ends("Kafka is not reached", with(unreachable, "gateway", "--journal", journal));
        out.getBuffer().setLength(0);
        mistake(
                "the Kafka broker at localhost:1 does not answer",
                with(unreachable, "gateway", "--journal", journal + 2));
    }

    private void ends(String running, String... arguments) throws Exception {
        Path log = directory.resolve(arguments[0] + ".log");
        Process program = TestProcess.start(log, Main.class, arguments);
        try {
            Awaitility.await()
                    .atMost(Duration.ofSeconds(90))
                    .until(() -> Files.readString(log).contains(running));
            program.destroy();
            assertThat(program.waitFor()).isZero();
        } finally {
            TestProcess.kill(program);
        }
    }

    /** An instance that can never run ends; it does not try again and again. */
    @Test
    void anInstanceThatCannotRunEnds() throws Exception {
        String[] cluster = {"--bootstrap", Brokers.shared(), "--name", Brokers.freshFleet()};
        assertThat(run(with(cluster, "fleet", "--create-topics", "--partitions", "1")))
                .isZero();
        out.getBuffer().setLength(0);
        mistake("/dev/null/s", with(cluster, "fleet", "--state-dir", "/dev/null/s"));
        mistake(
                "The session timeout is not within the range",
                with(cluster, "fleet", "--session-ms", "900", "--state-dir", directory.toString()));
        FleetSettings settings = FleetSettings.defaults().withFleet(cluster[3]).withStateDirectory(directory);
        try (Fleet first = new Fleet(KafkaCluster.at(Brokers.shared()), settings)) {
            mistake(
                    "each instance on a computer needs its own, given with --state-dir",
                    with(cluster, "fleet", "--state-dir", directory.toString()));
            assertThat(first.name()).isEqualTo(cluster[3]);
        }
    }

    @Test
    void topicsAreCreated() throws Exception {
        String name = Brokers.freshFleet();
        assertThat(run(
                        "fleet",
                        "--bootstrap",
                        Brokers.shared(),
                        "--name",
                        name,
                        "--create-topics",
                        "--partitions",
                        "3"))
                .isZero();
        assertThat(out.toString()).contains("the topics of the fleet '" + name + "' are there", "3 parts");
    }

    @Test
    void topicsAreCreatedAsWanted() throws Exception {
        String[] cluster = {"--bootstrap", Brokers.shared(), "--name", Brokers.freshFleet(), "--create-topics"};
        mistake("the number of replicas is -1", with(cluster, "fleet", "--replicas", "-1"));
        mistake("--replicas is 0; leave it out", with(cluster, "fleet", "--replicas", "0"));
        mistake(
                "cleanup.policy differs from topic to topic",
                with(cluster, "fleet", "--topic-config", "cleanup.policy=x"));
        mistake(
                "does not create the topic " + cluster[3] + ".devices: Unable to replicate the partition 2 time(s)",
                with(cluster, "fleet", "--replicas", "2"));
        mistake(
                "does not create the topic " + cluster[3] + ".devices: Unknown topic config name: nonsense",
                with(cluster, "fleet", "--topic-config", "nonsense=1"));
        String[] wanted = with(cluster, "fleet", "--replicas", "1", "--topic-config", "retention.ms=7200000");
        assertThat(run(wanted)).isZero();
        assertThat(run(wanted)).isZero();
        out.getBuffer().setLength(0);
        mistake(
                cluster[3] + ".effects has retention.ms=7200000, not 5",
                with(cluster, "fleet", "--topic-config", "retention.ms=5"));
        mistake(cluster[3] + ".effects has 1 replicas, not 3", with(cluster, "fleet", "--replicas", "3"));
    }

    @Test
    void aFleetsOwnTopicsAreCreatedAsWanted() throws Exception {
        String[] cluster = {"--bootstrap", Brokers.shared(), "--name", Brokers.freshFleet()};
        assertThat(run(with(cluster, "fleet", "--create-topics", "--partitions", "1")))
                .isZero();
        FleetSettings settings = FleetSettings.defaults()
                .withFleet(cluster[3])
                .withStateDirectory(directory)
                .withTopics(new TopicSettings(1, Map.of("segment.ms", "3600000")));
        try (Fleet fleet = new Fleet(KafkaCluster.at(Brokers.shared()), settings);
                Admin admin = Admin.create(Map.of("bootstrap.servers", Brokers.shared()))) {
            fleet.start();
            assertThat(fleet.awaitRunning(Duration.ofMinutes(1))).isTrue();
            ConfigResource changelog = new ConfigResource(ConfigResource.Type.TOPIC, cluster[3] + "-devices-changelog");
            assertThat(admin.describeConfigs(List.of(changelog))
                            .all()
                            .get()
                            .get(changelog)
                            .get("segment.ms")
                            .value())
                    .isEqualTo("3600000");
        }
    }

    @Test
    void modelsDevicesAndRolloutsAreWritten() throws Exception {
        String name = Brokers.freshFleet();
        String[] cluster = {"--bootstrap", Brokers.shared(), "--name", name};
        String lamp = Path.of(System.getProperty("evoloop.root", ".."), "models", "light-bulb.xml")
                .toString();
        assertThat(run(with(cluster, "fleet", "--create-topics"))).isZero();
        assertThat(run(with(cluster, "fleet", "publish", "lamp-1", lamp, "--timer", "wait:timeout:2000")))
                .isZero();
        assertThat(run(with(cluster, "fleet", "register", "--model", "lamp-1", "a", "b")))
                .isZero();
        assertThat(run(with(cluster, "fleet", "publish", "lamp-2", lamp, "--timer", "wait:timeout:500")))
                .isZero();
        assertThat(run(with(cluster, "fleet", "rollout", "r", "--from", "lamp-1", "--to", "lamp-2", "--percent", "10")))
                .isZero();
        assertThat(out.toString()).contains("lamp-1 are published", "2 written", "rollout r is written");
        out.getBuffer().setLength(0);
        mistake("other models are published as lamp-1 already", with(cluster, "fleet", "publish", "lamp-1", lamp));
        mistake("there are no models x", with(cluster, "fleet", "register", "--model", "x", "c"));
        mistake("there are no models x", with(cluster, "fleet", "rollout", "r", "--from", "lamp-1", "--to", "x"));
        mistake("are both lamp-1", with(cluster, "fleet", "rollout", "r", "--from", "lamp-1", "--to", "lamp-1"));
        mistake("divided into 8 parts already", with(cluster, "fleet", "--create-topics", "--partitions", "3"));
        mistake("there is no file none.xml", with(cluster, "fleet", "publish", "x", "none.xml"));
        mistake("cannot be read", with(cluster, "fleet", "publish", "x", directory.toString()));
        Path latin = Files.write(directory.resolve("latin.xml"), new byte[] {'<', (byte) 0xe9});
        mistake("is not text in UTF-8", with(cluster, "fleet", "publish", "x", latin.toString()));
        mistake("'no version'", with(cluster, "fleet", "publish", "no version", lamp));
        mistake("there is no state wiat", with(cluster, "fleet", "publish", "x", lamp, "--timer", "wiat:timeout:1"));
        mistake("raises timeuot, an event", with(cluster, "fleet", "publish", "x", lamp, "--timer", "wait:timeuot:1"));
        mistake("write STATE:EVENT:MS", with(cluster, "fleet", "publish", "x", lamp, "--timer", "wait"));
        mistake("nothing", with(cluster, "fleet", "publish", "x", lamp, "--new", "nothing"));
        mistake("101.0 %", with(cluster, "fleet", "rollout", "r", "--from", "a", "--to", "b", "--percent", "101"));
    }

    @Test
    void aRolloutIsRolledBackInAllDevicesThatItIncludes() throws Exception {
        String name = Brokers.freshFleet();
        String[] cluster = {"--bootstrap", Brokers.shared(), "--name", name};
        try (Cluster records = new Cluster(KafkaCluster.at(Brokers.shared()), name, 1)) {
            for (String version : List.of("lamp-1", "lamp-2", "lamp-3")) {
                records.write(Topic.MODELS, version, Models.LAMP.bytes());
            }
            records.flush();
            mistake("there is no rollout r", rollout(cluster, "r", "1", "2", "--back"));
            assertThat(run(rollout(cluster, "r", "1", "2", "--percent", "40"))).isZero();
            out.getBuffer().setLength(0);
            mistake("includes 40.0 % of the devices already", rollout(cluster, "r", "1", "2", "--percent", "30"));
            mistake("back and forth; repeat that rollout instead, with --back", rollout(cluster, "s", "2", "1"));
            mistake("the rollout r is from lamp-1 to lamp-2", rollout(cluster, "r", "1", "3"));
            assertThat(run(rollout(cluster, "r", "1", "2", "--back"))).isZero();
            records.readUntil(all -> all.of(Topic.ROLLOUTS, "r").size() == 2);
            assertThat(records.records().of(Topic.ROLLOUTS, "r").get(1))
                    .contains("\"percent\":40", "\"stopped\":\"by hand\"");
            out.getBuffer().setLength(0);
            mistake("from lamp-2 to lamp-1, so they would switch back and forth", rollout(cluster, "again", "1", "2"));
            assertThat(run(rollout(cluster, "r", "1", "2", "--percent", "5"))).isZero();
        }
    }

    private static String[] rollout(String[] cluster, String name, String from, String to, String... more) {
        return Stream.concat(
                        Stream.of("fleet", "rollout", name, "--from", "lamp-" + from, "--to", "lamp-" + to),
                        Stream.concat(Stream.of(more), Stream.of(cluster)))
                .toArray(String[]::new);
    }

    private static String[] with(String[] cluster, String... arguments) {
        return Stream.concat(Stream.of(arguments), Stream.of(cluster)).toArray(String[]::new);
    }
}
