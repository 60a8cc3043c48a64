package org.evoloop.models.record;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import java.util.List;
import org.evoloop.engine.Input;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Values;
import org.evoloop.journal.JournalRecord;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.junit.jupiter.api.Test;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

class RecordJsonTest {
    @Test
    void aNumberThatJsonLacksIsAText() {
        Values values = Values.of("never", Double.NaN)
                .with("most", Double.POSITIVE_INFINITY)
                .with("half", 0.5);
        Occurrence asked = new Occurrence.Asked(new Event("go"), values, 0, 1);
        JsonNode read = new JsonMapper()
                .readTree(RecordJson.line(new JournalRecord(
                        "1.journal",
                        1,
                        40,
                        Instant.EPOCH,
                        1,
                        "kind",
                        new Input.Observed(asked),
                        new Configuration(new State("On"), new State("Move")),
                        "",
                        List.of())));
        assertThat(read.path("values").path("never").stringValue()).isEqualTo("NaN");
        assertThat(read.path("values").path("most").stringValue()).isEqualTo("Infinity");
        assertThat(read.path("values").path("half").doubleValue()).isEqualTo(0.5);
    }
}
