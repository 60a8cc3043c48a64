package org.evoloop.fleet.demo;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayDeque;
import java.util.Deque;
import org.evoloop.fleet.Brokers;
import org.evoloop.fleet.Models;
import org.evoloop.fleet.stream.Fleet;
import org.evoloop.fleet.stream.FleetSettings;
import org.evoloop.fleet.stream.KafkaCluster;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Instances of a fleet leave and join while lamps are pressed. */
class RebalanceTest {
    @TempDir
    private Path directory;

    @Test
    void nothingIsLostAndNothingIsDoneTwiceWhenInstancesComeAndGo() throws Exception {
        String name = Brokers.freshFleet();
        FleetSettings settings = FleetSettings.defaults().withFleet(name).withPatience(Duration.ofSeconds(30));
        try (PressedLamps lamps = new PressedLamps(Brokers.shared(), name, 60, Models.LAMP)) {
            Deque<Fleet> instances = new ArrayDeque<>();
            for (int each = 0; each < 6; each++) {
                Fleet next = new Fleet(
                        KafkaCluster.at(Brokers.shared()), settings.withStateDirectory(directory.resolve("i" + each)));
                next.start();
                instances.add(next);
                if (each == 2) {
                    lamps.register();
                }
                if (each > 2) {
                    lamps.press(100);
                    instances.remove().close();
                    lamps.press(100);
                }
            }
            lamps.settle();
            instances.forEach(Fleet::close);
            assertThat(lamps.pressed()).isEqualTo(600);
        }
    }
}
