package org.evoloop.fleet.stream;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import org.evoloop.fleet.Models;
import org.evoloop.fleet.device.Answer;
import org.evoloop.fleet.wire.Reading;
import org.evoloop.fleet.wire.Topic;
import org.evoloop.fleet.wire.Wire;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Timers use the wall clock, and devices with different models run side by side. */
class TimersTest {
    @TempDir
    private Path directory;

    @Test
    void eachDeviceHasTheTimersOfItsOwnModelsAndNoneFiresEarly() throws Exception {
        try (RunningFleet fleet = new RunningFleet(directory)) {
            fleet.publish("quick", Models.lamp(300).bytes());
            fleet.publish("slow", Models.lamp(1_500).bytes());
            List<String> devices = List.of("quick", "slow");
            devices.forEach(device -> fleet.register(device, device));
            devices.forEach(fleet::press);
            devices.forEach(device -> fleet.answer(device, 1, Answer.Outcome.SENT));
            devices.forEach(device -> await(fleet, Topic.DECISIONS, device, "\"system\":\"on\"}}"));
            long pressed = RunningFleet.nowNanos();
            devices.forEach(fleet::press);
            for (String device : devices) {
                // The timer alone causes a command.
                fleet.answer(device, 2, Answer.Outcome.SENT);
                String timeout = await(fleet, Topic.DECISIONS, device, "\"source\":\"timer\"");
                long fired = reading(timeout).record().number("atMillis") - Wire.millis(pressed);
                assertThat(fired).as(device).isGreaterThanOrEqualTo(device.equals("quick") ? 300 : 1_500);
                assertThat(timeout).contains("\"model\":\"" + device + "\"", "\"outcome\":\"handled\"");
            }
        }
    }

    private static String await(RunningFleet fleet, Topic topic, String device, String part) {
        return fleet
                .cluster
                .readUntil(records -> records.of(topic, device).stream().anyMatch(record -> record.contains(part)))
                .of(topic, device)
                .stream()
                .filter(record -> record.contains(part))
                .findFirst()
                .orElseThrow();
    }

    private static Reading reading(String record) {
        return Reading.of(record.getBytes(StandardCharsets.UTF_8));
    }

    @Test
    void aTimerThatIsDueWhileNoInstanceRunsFiresLate() throws Exception {
        Path second = directory.resolve("second");
        try (RunningFleet fleet = new RunningFleet(directory.resolve("first"))) {
            fleet.publish("lamp", Models.lamp(300).bytes());
            fleet.register("lamp", "lamp");
            fleet.press("lamp");
            fleet.answer("lamp", 1, Answer.Outcome.SENT);
            await(fleet, Topic.DECISIONS, "lamp", "\"system\":\"on\"}}");
            // A press in the recent past, whose timer is already due when the record arrives.
            fleet.cluster.write(Topic.OCCURRENCES, "lamp", RunningFleet.press(RunningFleet.nowNanos()));
            await(fleet, Topic.STATES, "lamp", "timersMillis");
            fleet.restart(second);
            fleet.answer("lamp", 2, Answer.Outcome.SENT);
            assertThat(await(fleet, Topic.DECISIONS, "lamp", "\"source\":\"timer\""))
                    .contains("\"handled\"");
        }
    }
}
