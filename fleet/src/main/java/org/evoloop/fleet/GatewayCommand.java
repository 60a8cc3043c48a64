package org.evoloop.fleet;

import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.Set;
import java.util.concurrent.Callable;
import java.util.concurrent.CountDownLatch;
import org.evoloop.console.TerminationSignals;
import org.evoloop.fleet.gateway.Gateway;
import org.evoloop.fleet.observe.Health;
import org.evoloop.fleet.observe.ObservationServer;
import org.evoloop.fleet.stream.UnreachableException;
import org.evoloop.mqtt.BrokerAddress;
import org.evoloop.mqtt.MqttOptions;
import org.evoloop.mqtt.edge.EdgeDevice;
import org.evoloop.mqtt.edge.Outbox;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** Bridges the devices of an MQTT broker to a fleet. */
@Command(
        name = "gateway",
        description = {
            "Bridges the devices of an MQTT broker to a fleet, until it gets SIGTERM. While Kafka is unreachable, the devices'"
                    + " records are stored, and sent in order later."
        },
        mixinStandardHelpOptions = true,
        sortOptions = false,
        footer = {"", "Exit status: 0 success, 2 wrong usage or input."})
final class GatewayCommand implements Callable<Integer> {
    /** The most retained states that one connection to the broker holds. */
    private static final int MOST_DEVICES = 500;

    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @Mixin
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private ClusterOptions cluster;

    @Option(
            names = "--mqtt",
            required = true,
            paramLabel = "URL",
            description =
                    "The devices' MQTT broker: mqtt://USER@HOST, or mqtts://USER@HOST with TLS; the password is in"
                            + " the environment variable EVOLOOP_MQTT_PASSWORD.")
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private String mqtt;

    @Option(
            names = "--device",
            required = true,
            paramLabel = "ID",
            split = ",",
            description =
                    "The devices' ids in the fleet; they publish on evoloop/ID/occurrence and evoloop/ID/effect, and"
                            + " subscribe to evoloop/ID/command.")
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private Set<String> devices;

    @Option(
            names = "--journal",
            required = true,
            paramLabel = "DIR",
            description = "The directory for records not sent yet, and the commands already delivered.")
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private Path directory;

    @Option(
            names = "--gateway",
            paramLabel = "NAME",
            defaultValue = "gateway",
            description = "This gateway's name, unique in the fleet (default: gateway).")
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private String name;

    @Option(names = "--metrics", paramLabel = "[HOST:]PORT", description = ClusterOptions.METRICS)
    private @Nullable String metrics;

    @Override
    public Integer call() throws InterruptedException {
        EdgeDevice.requireTopicName("--gateway", name);
        for (String device : devices) {
            EdgeDevice.requireTopicName("the device", device);
        }
        if (devices.size() > MOST_DEVICES) {
            throw new IllegalArgumentException("--device names " + devices.size() + " devices, and a gateway takes "
                    + MOST_DEVICES + " at most; start another one for the rest, with another --gateway");
        }
        BrokerAddress broker = MqttOptions.brokerAt(mqtt);
        check();
        try (Gateway gateway =
                        new Gateway(cluster.cluster(), cluster.fleet(), name, broker, devices, directory, how -> {
                            spec.commandLine().getOut().println(how);
                            spec.commandLine().getOut().flush();
                        });
                ObservationServer observed = ClusterOptions.observed(
                        metrics,
                        gateway.metrics(),
                        () -> new Health(gateway.reachesKafka() && gateway.reachesDevices(), gateway.describe()))) {
            ClusterOptions.announce(observed, spec.commandLine().getErr());
            CountDownLatch ended = new CountDownLatch(1);
            TerminationSignals signals = new TerminationSignals(signal -> ended.countDown());
            gateway.start();
            ended.await();
            // A second signal ends it at once.
            signals.restore();
        } catch (UncheckedIOException unusable) {
            throw new IllegalArgumentException(
                    "--journal: " + unusable.getMessage()
                            + "; give a directory that this program may write, and no other uses",
                    unusable);
        }
        return 0;
    }

    /** A gateway that has run before stores the devices' records until Kafka answers, also after a restart meanwhile. */
    private void check() {
        try {
            cluster.check();
        } catch (UnreachableException unreachable) {
            if (!Outbox.isIn(directory)) {
                throw unreachable;
            }
            spec.commandLine().getErr().println("evoloop: " + unreachable.getMessage());
        }
    }
}
