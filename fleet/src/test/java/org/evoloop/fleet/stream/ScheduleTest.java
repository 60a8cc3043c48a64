package org.evoloop.fleet.stream;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.HashMap;
import java.util.Map;
import java.util.Random;
import org.evoloop.fleet.device.Device;
import org.junit.jupiter.api.Test;

class ScheduleTest {
    private final Schedule schedule = new Schedule();

    @Test
    void theEarliestComesFirstAndWhatIsCalledOffNever() {
        schedule.set("b", 20);
        schedule.set("c", 10);
        schedule.set("a", 20);
        schedule.set("d", 5);
        schedule.set("d", Device.NEVER);
        schedule.set("c", 30);
        assertThat(schedule.poll(19)).isNull();
        assertThat(schedule.poll(20)).isEqualTo("a");
        assertThat(schedule.poll(20)).isEqualTo("b");
        assertThat(schedule.poll(20)).isNull();
        assertThat(schedule.poll(30)).isEqualTo("c");
        assertThat(schedule.poll(Device.NEVER)).isNull();
    }

    @Test
    void whateverIsSetIsPolledInOrderAsTheLastTimeSays() {
        long seed = new Random().nextLong();
        Random random = new Random(seed);
        Map<String, Long> expected = new HashMap<>();
        for (int step = 0; step < 20_000; step++) {
            String device = "device-" + random.nextInt(300);
            long at = random.nextInt(3) == 0 ? Device.NEVER : random.nextInt(1_000);
            schedule.set(device, at);
            expected.put(device, at);
            if (step % 500 == 0) {
                long now = random.nextInt(1_000);
                long last = 0;
                for (String due = schedule.poll(now); due != null; due = schedule.poll(now)) {
                    assertThat(expected.get(due)).as("seed %d", seed).isBetween(last, now);
                    last = expected.put(due, Device.NEVER);
                }
                assertThat(expected.values()).as("seed %d", seed).allMatch(left -> left > now);
            }
        }
    }

    @Test
    void whatIsCalledOffTakesNoRoom() {
        for (int round = 0; round < 100_000; round++) {
            schedule.set("device-" + round, round);
            schedule.set("device-" + round, Device.NEVER);
        }
        assertThat(schedule.queued()).isLessThan(2_000);
    }
}
