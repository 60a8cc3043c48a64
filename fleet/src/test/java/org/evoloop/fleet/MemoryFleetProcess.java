package org.evoloop.fleet;

import java.nio.file.Path;
import java.time.Duration;
import org.evoloop.fleet.stream.Fleet;
import org.evoloop.fleet.stream.FleetSettings;
import org.evoloop.fleet.stream.KafkaCluster;

/**
 * An instance that keeps its devices in memory, in a separate process, which can be killed; its arguments are the broker,
 * the fleet's name, the session timeout in milliseconds, and a directory.
 */
public final class MemoryFleetProcess {
    private MemoryFleetProcess() {}

    public static void main(String[] arguments) throws InterruptedException {
        FleetSettings settings = FleetSettings.defaults()
                .withFleet(arguments[1])
                .withSession(Duration.ofMillis(Long.parseLong(arguments[2])))
                .withStateDirectory(Path.of(arguments[3]))
                .withDevicesInMemory();
        try (Fleet fleet = new Fleet(KafkaCluster.at(arguments[0]), settings)) {
            fleet.start();
            fleet.awaitEnd();
        }
    }
}
