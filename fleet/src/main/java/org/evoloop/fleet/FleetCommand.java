package org.evoloop.fleet;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.Callable;
import org.evoloop.console.TerminationSignals;
import org.evoloop.fleet.broker.LocalBroker;
import org.evoloop.fleet.demo.Demo;
import org.evoloop.fleet.observe.Health;
import org.evoloop.fleet.observe.ObservationServer;
import org.evoloop.fleet.program.Lamp;
import org.evoloop.fleet.program.Scratch;
import org.evoloop.fleet.stream.Fleet;
import org.evoloop.fleet.stream.FleetException;
import org.evoloop.fleet.stream.FleetSettings;
import org.evoloop.fleet.stream.FleetTopics;
import org.evoloop.fleet.stream.KafkaCluster;
import org.evoloop.fleet.stream.TopicSettings;
import org.evoloop.fleet.wire.ModelRecord;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** Runs an instance of a fleet, or shows one. */
@Command(
        name = "fleet",
        description = {
            "Converts the events of many devices on a Kafka cluster, until it gets SIGTERM. All instances with the same"
                    + " name share the work. docs/fleet.md describes the topics."
        },
        mixinStandardHelpOptions = true,
        sortOptions = false,
        subcommands = {PublishCommand.class, RegisterCommand.class, RolloutCommand.class, ResendCommand.class},
        footer = {"", "Exit status: 0 success, 1 the demo found a problem, 2 wrong usage or input."})
final class FleetCommand implements Callable<Integer> {
    private static final Duration START_LIMIT = Duration.ofMinutes(10);
    private static final int PARTITIONS = 8;
    private static final int MOST_DEVICES = 1_000_000;

    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @Option(
            names = "--demo",
            description =
                    "Shows a fleet of simulated lamps: presses, bad records, an instance that leaves, and models that"
                            + " take over. Starts a broker of its own unless --bootstrap names one. Takes a minute.")
    private boolean demo;

    @Option(names = "--devices", paramLabel = "N", description = "The number of lamps in the demo (default: 1000).")
    private @Nullable Integer devices;

    @Option(names = "--bootstrap", paramLabel = "HOST:PORT", description = "A broker of the cluster.")
    private @Nullable String bootstrap;

    @Option(names = "--kafka-config", paramLabel = "FILE", description = ClusterOptions.KAFKA_CONFIG)
    private @Nullable Path kafkaConfig;

    @Option(
            names = "--name",
            paramLabel = "NAME",
            defaultValue = "evoloop",
            description = "The fleet's name, the prefix of its topics (default: evoloop).")
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private String name;

    @Option(names = "--create-topics", description = "Creates the missing topics, and exits.")
    private boolean createTopics;

    @Option(
            names = "--partitions",
            paramLabel = "N",
            description =
                    "The number of partitions that --create-topics creates; it cannot be changed later (default: 8).")
    private @Nullable Integer partitions;

    @Option(
            names = "--replicas",
            paramLabel = "N",
            description =
                    "How many brokers keep each partition of the topics that this creates; give it to --create-topics"
                            + " and to the instances, which create some for their state (default: as the cluster does).")
    private @Nullable Integer replicas;

    @Option(
            names = "--topic-config",
            paramLabel = "NAME=VALUE",
            description = "A setting of Kafka's for these topics, such as min.insync.replicas=2; may be repeated.")
    private Map<String, String> topicConfig = new TreeMap<>();

    @Option(
            names = "--threads",
            paramLabel = "N",
            defaultValue = "1",
            description = "The number of threads (default: 1).")
    private int threads;

    @Option(
            names = "--standbys",
            paramLabel = "N",
            defaultValue = "0",
            description = "How many other instances hold a copy of each device, for faster takeover (default: 0).")
    private int standbys;

    @Option(
            names = "--state-dir",
            paramLabel = "DIR",
            description =
                    "The directory for a copy of the devices' states, which makes restarts fast (default: a directory"
                            + " in /var/tmp).")
    private @Nullable Path stateDirectory;

    @Option(
            names = "--commit-ms",
            paramLabel = "MS",
            defaultValue = "100",
            description = "The interval between commits: short for latency, long for throughput (default: 100).")
    private long commitMillis;

    @Option(
            names = "--session-ms",
            paramLabel = "MS",
            defaultValue = "10000",
            description = "After this silence of an instance, the others take its devices (default: 10000).")
    private long sessionMillis;

    @Option(names = "--metrics", paramLabel = "[HOST:]PORT", description = ClusterOptions.METRICS)
    private @Nullable String metrics;

    @Override
    public Integer call() throws Exception {
        if (partitions != null && !createTopics) {
            throw new ParameterException(spec.commandLine(), "--partitions is for --create-topics");
        }
        if (demo) {
            return demo();
        }
        if (bootstrap == null) {
            throw new ParameterException(spec.commandLine(), "give --bootstrap HOST:PORT, or --demo");
        } else if (devices != null) {
            throw new ParameterException(spec.commandLine(), "--devices is for --demo");
        }
        KafkaCluster cluster = ClusterOptions.cluster(bootstrap, kafkaConfig);
        return createTopics ? create(cluster) : run(cluster);
    }

    private int create(KafkaCluster cluster) {
        int wanted = partitions == null ? PARTITIONS : partitions;
        if (wanted < 1 || wanted > 10_000) {
            throw new IllegalArgumentException("--partitions is " + wanted + ", allowed is 1 to 10000");
        }
        FleetSettings settings = settings();
        try (FleetTopics topics = new FleetTopics(cluster, settings.fleet())) {
            topics.create(wanted, settings.topics());
            int found = topics.check();
            if (partitions != null && found != wanted) {
                throw new FleetException("the devices of the fleet '" + name + "' are divided into " + found
                        + " parts already, not into " + wanted
                        + "; that cannot be changed, so leave out --partitions or take another --name");
            }
            List<String> differences = topics.differences(settings.topics());
            if (!differences.isEmpty()) {
                throw new FleetException("some topics were there already, and are not changed:\n  "
                        + String.join("\n  ", differences)
                        + "\nChange them with Kafka's own tools, or leave out --replicas and --topic-config");
            }
            spec.commandLine()
                    .getOut()
                    .println("the topics of the fleet '" + name + "' are there; devices are divided into " + found
                            + " parts");
        }
        return 0;
    }

    private int run(KafkaCluster cluster) throws InterruptedException {
        FleetSettings settings = settings();
        try (FleetTopics topics = new FleetTopics(cluster, settings.fleet())) {
            topics.check();
        }
        try (Fleet fleet = new Fleet(cluster, settings);
                ObservationServer observed = ClusterOptions.observed(
                        metrics,
                        fleet.metrics(),
                        () -> new Health(fleet.isRunning() && fleet.reachesKafka(), fleet.describe()))) {
            ClusterOptions.announce(observed, spec.commandLine().getErr());
            Runnable end = fleet::close;
            TerminationSignals signals = new TerminationSignals(signal -> end.run());
            try {
                fleet.start();
                if (fleet.awaitRunning(START_LIMIT)) {
                    spec.commandLine().getErr().println("evoloop: an instance of the fleet '" + name + "' runs");
                }
                fleet.awaitEnd();
            } finally {
                signals.restore();
            }
        }
        return 0;
    }

    private FleetSettings settings() {
        FleetSettings settings = FleetSettings.defaults()
                .withFleet(name)
                .withTopics(topicSettings())
                .withThreads(threads)
                .withStandbys(standbys)
                .withSession(Duration.ofMillis(sessionMillis))
                .withCommitInterval(Duration.ofMillis(commitMillis));
        Path directory = stateDirectory;
        return settings.withStateDirectory(directory == null ? Path.of("/var/tmp/evoloop-fleet-" + name) : directory);
    }

    private TopicSettings topicSettings() {
        if (replicas != null && replicas == 0) {
            throw new IllegalArgumentException(
                    "--replicas is 0; leave it out for as many as the cluster does by default");
        }
        return new TopicSettings(replicas == null ? 0 : replicas, topicConfig);
    }

    private int demo() throws IOException, InterruptedException {
        int number = devices == null ? 1_000 : devices;
        if (number < 1 || number > MOST_DEVICES) {
            throw new IllegalArgumentException("--devices is " + number + ", allowed is 1 to " + MOST_DEVICES);
        }
        ModelRecord lamp = Lamp.waiting(2_000);
        try (Scratch scratch = new Scratch()) {
            if (bootstrap != null) {
                KafkaCluster given = ClusterOptions.cluster(bootstrap, kafkaConfig);
                return demo(given, name + "-demo-" + System.currentTimeMillis(), lamp, number, scratch.directory());
            }
            spec.commandLine().getErr().println("evoloop: starting a broker");
            try (LocalBroker broker = LocalBroker.start(scratch.directory().resolve("broker"))) {
                KafkaCluster own = KafkaCluster.at(broker.bootstrap());
                return demo(own, name, lamp, number, scratch.directory());
            }
        }
    }

    private int demo(KafkaCluster cluster, String fleet, ModelRecord lamp, int number, Path directory)
            throws InterruptedException {
        List<String> problems;
        try (Demo shown = new Demo(
                cluster, fleet, lamp, number, directory, spec.commandLine().getOut())) {
            problems = shown.run();
        }
        if (bootstrap != null) {
            try (FleetTopics topics = new FleetTopics(cluster, fleet)) {
                topics.delete();
            }
        }
        problems.forEach(problem -> spec.commandLine().getErr().println("evoloop: " + problem));
        spec.commandLine()
                .getOut()
                .println(
                        problems.isEmpty()
                                ? "nothing was lost, and nothing was done twice"
                                : problems.size() + " problems were found");
        return problems.isEmpty() ? 0 : 1;
    }
}
