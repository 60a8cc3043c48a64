package org.evoloop.fleet.stream;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import java.util.stream.IntStream;
import org.evoloop.fleet.Models;
import org.evoloop.fleet.TopicRecords;
import org.evoloop.fleet.device.Answer;
import org.evoloop.fleet.wire.Rollout;
import org.evoloop.fleet.wire.Topic;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Rollouts switch a share of the devices to other models, and are rolled back after too many failures. */
class RolloutTest {
    private static final List<String> DEVICES =
            IntStream.range(0, 40).mapToObj(each -> "lamp-" + each).toList();

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
}
