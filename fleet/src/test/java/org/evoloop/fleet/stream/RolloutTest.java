package org.evoloop.fleet.stream;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Properties;
import java.util.stream.IntStream;
import org.apache.kafka.common.serialization.ByteArraySerializer;
import org.apache.kafka.common.serialization.StringDeserializer;
import org.apache.kafka.common.serialization.StringSerializer;
import org.apache.kafka.streams.StreamsConfig;
import org.apache.kafka.streams.TestOutputTopic;
import org.apache.kafka.streams.TopologyTestDriver;
import org.evoloop.fleet.Models;
import org.evoloop.fleet.TopicRecords;
import org.evoloop.fleet.device.Answer;
import org.evoloop.fleet.wire.Rollout;
import org.evoloop.fleet.wire.Topic;
import org.evoloop.fleet.wire.Wire;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Rollouts switch a share of the devices to other models, and are rolled back after too many failures. */
class RolloutTest {
    private static final List<String> DEVICES =
            IntStream.range(0, 40).mapToObj(each -> "lamp-" + each).toList();

    private static final Rollout ALL = new Rollout("all", "lamp-1", "lamp-2", 100, "", 5, 20, "");

    @TempDir
    private Path directory;

    @Test
    void aRolloutIncludesItsShareAndStopsByItself() throws Exception {
        Rollout half = new Rollout("to-2", "lamp-1", "lamp-2", 50, "", 10, 4, "");
        List<String> taken = DEVICES.stream().filter(half::takesIn).toList();
        assertThat(taken.size()).isBetween(8, 32);
        try (RunningFleet fleet = new RunningFleet(directory)) {
            fleet.publish("lamp-1", Models.LAMP.bytes());
            fleet.publish("lamp-2", Models.lamp(1_000).bytes());
            DEVICES.forEach(device -> fleet.register(device, "lamp-1"));
            fleet.cluster.write(Topic.ROLLOUTS, half.name(), half.bytes());
            // Idle devices, for which there were no records, are included.
            fleet.cluster.readUntil(records -> taken.stream().allMatch(device -> has(records, device, "lamp-2")));
            List<String> others =
                    DEVICES.stream().filter(device -> !half.takesIn(device)).toList();
            assertThat(others).allMatch(device -> has(fleet.cluster.records(), device, "lamp-1"));
            for (String device : taken.subList(0, 5)) {
                fleet.press(device);
                fleet.answer(device, 1, Answer.Outcome.FAILED);
            }
            fleet.cluster.readUntil(
                    records -> records.of(Topic.ROLLOUTS, half.name()).size() == 2);
            assertThat(fleet.cluster.records().of(Topic.ROLLOUTS, half.name()).get(1))
                    .containsPattern("\"stopped\":\"\\d of \\d were failures or divergences, more than 10.0 %\"");
            fleet.cluster.readUntil(records -> DEVICES.stream().allMatch(device -> has(records, device, "lamp-1")));
        }
    }

    private static boolean has(TopicRecords records, String device, String model) {
        List<String> states = records.of(Topic.STATES, device);
        return states.get(states.size() - 1).contains("\"model\":\"" + model + "\"");
    }

    @Test
    void aGreaterShareIncludesAllDevicesOfASmallerOne() {
        Rollout one = new Rollout("x", "a", "b", 1, "", 5, 20, "");
        List<String> many =
                IntStream.range(0, 20_000).mapToObj(each -> "d" + each).toList();
        long before = 0;
        for (double percent : new double[] {1, 10, 50, 100}) {
            Rollout next = one.withPercent(percent);
            assertThat(many.stream().filter(one::takesIn)).allMatch(next::takesIn);
            long taken = many.stream().filter(next::takesIn).count();
            assertThat(taken).isGreaterThan(before).isBetween((long) (180 * percent), (long) (220 * percent));
            before = taken;
        }
        assertThat(before).isEqualTo(many.size());
    }

    /** A fleet in Kafka Streams' own broker for tests, where records arrive in the order of this program. */
    private static final class DrivenFleet implements AutoCloseable {
        private final FleetSettings settings = FleetSettings.defaults().withDevicesInMemory();
        private final TopologyTestDriver driver = new TopologyTestDriver(FleetTopology.of(settings), properties());
        private final TestOutputTopic<String, String> states = driver.createOutputTopic(
                Topic.STATES.of(settings.fleet()), new StringDeserializer(), new StringDeserializer());

        private Properties properties() {
            Properties properties = new Properties();
            properties.put(StreamsConfig.APPLICATION_ID_CONFIG, settings.fleet());
            return properties;
        }

        /** Writes a record, and gives the fleet the time to look at its rollouts and at idle devices. */
        void write(Topic topic, String key, byte @Nullable [] record) {
            driver.createInputTopic(topic.of(settings.fleet()), new StringSerializer(), new ByteArraySerializer())
                    .pipeInput(key, record);
            driver.advanceWallClockTime(Duration.ofSeconds(1));
            driver.advanceWallClockTime(Duration.ofSeconds(1));
        }

        String stateOf(String device) {
            return states.readKeyValuesToMap().getOrDefault(device, "");
        }

        @Override
        public void close() {
            driver.close();
        }
    }

    @Test
    void aRolloutThatComesBeforeItsModelsWaitsForThem() {
        try (DrivenFleet fleet = new DrivenFleet()) {
            fleet.write(Topic.MODELS, "lamp-1", Models.LAMP.bytes());
            fleet.write(Topic.DEVICES, "hall", Wire.device("lamp-1"));
            fleet.write(Topic.ROLLOUTS, "all", ALL.bytes());
            assertThat(fleet.stateOf("hall")).contains("\"model\":\"lamp-1\"");

            fleet.write(Topic.MODELS, "lamp-2", Models.lamp(1_000).bytes());
            assertThat(fleet.stateOf("hall")).contains("\"model\":\"lamp-2\"");
        }
    }

    /** With the same record as before; what counted against the first attempt does not count against the second. */
    @Test
    void aRolloutThatWasStoppedCanBeRepeatedAndStopsAgain() {
        try (DrivenFleet fleet = new DrivenFleet()) {
            fleet.write(Topic.MODELS, "lamp-1", Models.LAMP.bytes());
            fleet.write(Topic.MODELS, "lamp-2", Models.lamp(1_000).bytes());
            fleet.write(Topic.DEVICES, "hall", Wire.device("lamp-1"));
            for (int attempt = 1; attempt <= 3; attempt++) {
                fleet.write(Topic.ROLLOUTS, "all", ALL.bytes());
                assertThat(fleet.stateOf("hall")).contains("\"model\":\"lamp-2\"");
                fleet.write(Topic.VERDICTS, "all", RolloutWatch.verdict(10, 0));
                fleet.write(Topic.VERDICTS, "all", RolloutWatch.verdict(0, 9));
                assertThat(fleet.stateOf("hall")).isEmpty();
                fleet.write(Topic.VERDICTS, "all", RolloutWatch.verdict(0, 1));
                assertThat(fleet.stateOf("hall")).contains("\"model\":\"lamp-1\"");
            }
        }
    }

    @Test
    void aDeletedRolloutTakesInNoMoreDevices() {
        try (DrivenFleet fleet = new DrivenFleet()) {
            fleet.write(Topic.MODELS, "lamp-1", Models.LAMP.bytes());
            fleet.write(Topic.MODELS, "lamp-2", Models.lamp(1_000).bytes());
            fleet.write(Topic.ROLLOUTS, "all", ALL.bytes());
            fleet.write(Topic.DEVICES, "hall", Wire.device("lamp-1"));
            assertThat(fleet.stateOf("hall")).contains("\"model\":\"lamp-2\"");

            fleet.write(Topic.ROLLOUTS, "all", null);
            fleet.write(Topic.DEVICES, "kitchen", Wire.device("lamp-1"));
            assertThat(fleet.stateOf("kitchen")).contains("\"model\":\"lamp-1\"");
        }
    }
}
