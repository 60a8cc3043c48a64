package org.evoloop.fleet.stream;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.time.Duration;
import org.evoloop.fleet.Brokers;
import org.evoloop.fleet.Cluster;
import org.evoloop.fleet.Models;
import org.evoloop.fleet.TopicRecords;
import org.evoloop.fleet.device.Model;
import org.evoloop.fleet.wire.ModelRecord;
import org.evoloop.fleet.wire.Topic;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** With a real broker each device writes the same records as its core alone, byte for byte. */
class SameAsAloneTest {
    @TempDir
    private Path directory;

    @Test
    void devicesWriteTheSameRecordsAsTheirCoresAlone() throws Exception {
        compare(200, 30, 4);
    }

    @Test
    @Tag("slow")
    void tenThousandRandomSequencesGiveTheSameRecords() throws Exception {
        compare(10_000, 20, 8);
    }

    private void compare(int devices, int steps, int partitions) throws Exception {
        long seed = System.nanoTime();
        System.out.println("seed " + seed);
        Model model = ModelRecord.read("lamp-1", Models.LAMP.bytes());
        Story story = new Story(model, seed, devices, steps);
        try (Cluster cluster = Cluster.fresh(partitions)) {
            cluster.write(Topic.MODELS, "lamp-1", Models.LAMP.bytes());
            story.entries()
                    .forEach(entry -> cluster.write(entry.topic(), entry.device(), entry.record(), entry.atMillis()));
            cluster.flush();
            TopicRecords expected = story.recordsAt(cluster);
            FleetSettings settings = FleetSettings.defaults()
                    .withFleet(cluster.fleet())
                    .withStateDirectory(directory)
                    .withStreamTime();
            try (Fleet fleet = new Fleet(KafkaCluster.at(Brokers.shared()), settings)) {
                fleet.start();
                assertThat(fleet.awaitRunning(Duration.ofMinutes(1))).isTrue();
                cluster.readUntil(records -> records.size() >= expected.size());
            }
            cluster.read(Duration.ofMillis(500));
            expected.all()
                    .forEach((key, records) ->
                            assertThat(cluster.records().all().get(key)).as(key).isEqualTo(records));
            assertThat(cluster.records().all().keySet())
                    .isEqualTo(expected.all().keySet());
        }
    }
}
