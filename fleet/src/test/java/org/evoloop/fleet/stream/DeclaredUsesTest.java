package org.evoloop.fleet.stream;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Source;
import org.evoloop.evolution.Values;
import org.evoloop.fleet.Models;
import org.evoloop.fleet.device.Answer;
import org.evoloop.fleet.wire.Topic;
import org.evoloop.fleet.wire.Wire;
import org.evoloop.statemachine.Event;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What a program declares in code reaches the fleet's instances with the models. */
class DeclaredUsesTest {
    @TempDir
    private Path directory;

    @Test
    void aNewStateTakesTheDeviceWhereItNeedsIt() throws Exception {
        try (RunningFleet fleet = new RunningFleet(directory)) {
            fleet.publish("fan", Models.FAN_IN_CODE.bytes());
            fleet.register("attic", "fan");
            Event boost = new Event("boost");
            long now = RunningFleet.nowNanos();
            fleet.cluster.write(
                    Topic.OCCURRENCES,
                    "attic",
                    Wire.occurrence(
                            new Occurrence.Heard(boost, Values.NONE, Source.CONTROLLER, Occurrence.ANY_VISIT, now), 0));
            fleet.answer("attic", 1, Answer.Outcome.SENT);
            fleet.answer("attic", 2, Answer.Outcome.SENT);
            assertThat(fleet.cluster
                            .readUntil(records -> records.of(Topic.STATES, "attic").stream()
                                    .anyMatch(state -> state.contains("\"system\":\"Boost\"")))
                            .of(Topic.STATES, "attic"))
                    .last()
                    .asString()
                    .contains("\"device\":\"High\"", "\"function\":true");
        }
    }
}
