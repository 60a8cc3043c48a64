package org.evoloop.fleet.stream;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import org.evoloop.fleet.Models;
import org.evoloop.fleet.device.Answer;
import org.evoloop.fleet.wire.Topic;
import org.evoloop.fleet.wire.Wire;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A record that cannot be processed becomes a dead letter with its reason, and does not block others. */
class BadRecordsTest {
    @TempDir
    private Path directory;

    @Test
    void eachBadRecordBecomesADeadLetterAndBlocksNoOther() throws Exception {
        try (RunningFleet fleet = new RunningFleet(directory)) {
            fleet.publish("lamp-1", Models.LAMP.bytes());
            fleet.register("good", "lamp-1");
            long now = RunningFleet.nowNanos();
            long hour = 3_600_000_000_000L;
            bad(fleet, "a", Topic.OCCURRENCES, "{\"schema\":1,", "malformed", "not valid JSON");
            bad(fleet, "b", Topic.OCCURRENCES, "[1]", "malformed", "a JSON object was expected");
            bad(fleet, "c", Topic.OCCURRENCES, "{\"schema\":2}", "newer-schema", "update it first");
            bad(fleet, "c", Topic.OCCURRENCES, "{\"event\":\"switch\"}", "malformed", "it has no schema; write");
            bad(fleet, "c", Topic.DEVICES, "{\"model\":\"lamp-1\"}", "malformed", "it has no schema; write");
            bad(fleet, "d", Topic.OCCURRENCES, Wire.text(RunningFleet.press(now)), "unknown-device", "no device d");
            bad(fleet, "e", Topic.DEVICES, "{\"schema\":1,\"model\":\"none\"}", "unknown-model", "publish them first");
            bad(fleet, "good", Topic.OCCURRENCES, Wire.text(RunningFleet.press(now + hour)), "clock", "ahead of");
            bad(fleet, "good", Topic.OCCURRENCES, Wire.text(RunningFleet.press(0)), "clock", "behind");
            bad(
                    fleet,
                    "good",
                    Topic.OCCURRENCES,
                    "{\"schema\":1,\"atMillis\":1}",
                    "malformed",
                    "'event' must be a string");
            String large = Wire.text(RunningFleet.press(now)).replace("}", ",\"values\":{\"level\":1e999}}");
            bad(fleet, "good", Topic.OCCURRENCES, large, "malformed", "the number 'level' is too large; send one");
            bad(fleet, "good", Topic.EFFECTS, "{\"schema\":1,\"sequence\":\"x\"}", "malformed", "'sequence' must be");
            bad(fleet, "good", Topic.DEVICES, "{\"schema\":1,\"model\":\"other\"}", "registered-already", "a rollout");
            // What is sent and stored because of such a record would be larger than the broker takes.
            String rest = "z".repeat(1_040_000);
            bad(
                    fleet,
                    "good",
                    Topic.OCCURRENCES,
                    "{\"schema\":1," + rest,
                    "malformed",
                    "it is not valid JSON: line 1, column 13");
            String kind = Wire.text(RunningFleet.press(now)).replace("heard", rest);
            bad(fleet, "good", Topic.OCCURRENCES, kind, "malformed", "'zzz");
            String event = Wire.text(RunningFleet.press(now)).replace("switch", rest);
            bad(
                    fleet,
                    "good",
                    Topic.OCCURRENCES,
                    event,
                    "malformed",
                    "'event' has 1040000 characters, allowed are 1000");
            fleet.press("good");
            fleet.cluster.readUntil(
                    records -> records.of(Topic.COMMANDS, "good").size() == 1);
            Answer failed = new Answer(1, Answer.Outcome.FAILED, rest, null, now);
            bad(fleet, "good", Topic.EFFECTS, Wire.text(Wire.effect(failed)), "too-large", "DECISIONS would have 1040");
            fleet.answer("good", 1, Answer.Outcome.SENT);
            fleet.cluster.readUntil(
                    records -> records.of(Topic.DECISIONS, "good").size() == 1);
            assertThat(fleet.cluster.records().of(Topic.DECISIONS, "good").get(0))
                    .contains("\"outcome\":\"handled\"");
        }
    }

    /** Its executor skips commands with the numbers of earlier ones, and its edge visits. */
    @Test
    void aDeviceThatIsRegisteredAgainContinuesItsNumbers() throws Exception {
        try (RunningFleet fleet = new RunningFleet(directory)) {
            fleet.publish("lamp-1", Models.LAMP.bytes());
            fleet.register("lamp", "lamp-1");
            fleet.press("lamp");
            fleet.answer("lamp", 1, Answer.Outcome.SENT);
            fleet.cluster.readUntil(
                    records -> records.of(Topic.DECISIONS, "lamp").size() == 1);
            fleet.cluster.write(Topic.DEVICES, "lamp", null);
            awaitStates(fleet, 3);
            String press = Wire.text(RunningFleet.press(RunningFleet.nowNanos()));
            bad(fleet, "lamp", Topic.OCCURRENCES, press, "unknown-device", "no device lamp");
            fleet.cluster.write(Topic.DEVICES, "lamp", Wire.device("lamp-1"));
            awaitStates(fleet, 4);
            fleet.press("lamp");
            fleet.answer("lamp", 2, Answer.Outcome.SENT);
            fleet.cluster.readUntil(
                    records -> records.of(Topic.DECISIONS, "lamp").size() == 2);
            assertThat(fleet.cluster.records().of(Topic.COMMANDS, "lamp").get(1))
                    .contains("\"sequence\":2,");
            List<String> states = fleet.cluster.records().of(Topic.STATES, "lamp");
            assertThat(states.subList(2, 5))
                    .satisfiesExactly(
                            removed -> assertThat(removed).isEqualTo("null"),
                            again -> assertThat(again).contains("\"system\":\"off\",\"visit\":3,", "\"sequence\":1,"),
                            pressed -> assertThat(pressed).contains("\"system\":\"on\",\"visit\":4,"));
        }
    }

    private static void awaitStates(RunningFleet fleet, int number) {
        fleet.cluster.readUntil(records -> records.of(Topic.STATES, "lamp").size() == number);
    }

    private static void bad(
            RunningFleet fleet, String device, Topic topic, String record, String reason, String detail) {
        int before = fleet.cluster.records().of(Topic.DEAD_LETTERS, device).size();
        fleet.cluster.write(topic, device, record.getBytes(StandardCharsets.UTF_8));
        List<String> letters = fleet.cluster
                .readUntil(records -> records.of(Topic.DEAD_LETTERS, device).size() > before)
                .of(Topic.DEAD_LETTERS, device);
        assertThat(letters.get(before))
                .contains("\"reason\":\"" + reason + "\"")
                .contains(detail)
                .contains("\"topic\":\"" + topic.of(fleet.cluster.fleet()) + "\"");
    }

    @Test
    void modelsThatAreNoModelsAreRefusedWhereADeviceWantsThem() throws Exception {
        try (RunningFleet fleet = new RunningFleet(directory)) {
            byte[] broken = Wire.text(Models.LAMP.bytes())
                    .replace("\"original\":\"original\"", "\"original\":\"nothing\"")
                    .getBytes(StandardCharsets.UTF_8);
            fleet.cluster.write(Topic.MODELS, "broken", broken);
            fleet.publish("lamp-1", Models.LAMP.bytes());
            bad(fleet, "a", Topic.DEVICES, "{\"schema\":1,\"model\":\"broken\"}", "unusable-model", "nothing");
            fleet.register("a", "lamp-1");
        }
    }
}
