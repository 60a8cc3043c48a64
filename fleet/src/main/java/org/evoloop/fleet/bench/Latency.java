package org.evoloop.fleet.bench;

import java.nio.file.Path;
import java.time.Duration;
import org.evoloop.fleet.demo.Latencies;
import org.evoloop.fleet.demo.Presses;
import org.evoloop.fleet.stream.Fleet;
import org.evoloop.fleet.stream.FleetException;
import org.evoloop.fleet.stream.FleetSettings;
import org.evoloop.fleet.stream.KafkaCluster;
import org.evoloop.fleet.wire.ModelRecord;

/** Measures the time from an occurrence to its command, both at the edge, at some hundred occurrences per second. */
final class Latency {
    private final KafkaCluster cluster;
    private final Path directory;
    private final ModelRecord lamp;
    private int runs;

    Latency(KafkaCluster cluster, Path directory, ModelRecord lamp) {
        this.cluster = cluster;
        this.directory = directory;
        this.lamp = lamp;
    }

    /** The latencies of {@code presses} presses, {@code perSecond} per second, in milliseconds. */
    Latencies of(Duration commitInterval, int presses, int perSecond) throws InterruptedException {
        runs++;
        String name = "latency-" + runs;
        FleetSettings settings = FleetSettings.defaults()
                .withFleet(name)
                .withStateDirectory(directory.resolve(name))
                .withCommitInterval(commitInterval);
        try (Presses lamps = new Presses(cluster, name, lamp, presses);
                Fleet fleet = new Fleet(cluster, settings)) {
            fleet.start();
            if (!fleet.awaitRunning(Duration.ofMinutes(1))) {
                throw new FleetException("the fleet did not start");
            }
            return lamps.pressEachOnce(perSecond);
        }
    }
}
