package org.evoloop.page;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import org.evoloop.converter.HistoryEntry;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Outcome;
import org.evoloop.evolution.Source;
import org.evoloop.evolution.Values;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.junit.jupiter.api.Test;
import tools.jackson.databind.json.JsonMapper;

class EntryJsonTest {
    @Test
    void aNumberThatJsonLacksIsShown() {
        Configuration at = new Configuration(new State("on"), new State("on"));
        Values values = Values.of("level", Double.NaN).with("most", Double.POSITIVE_INFINITY);
        Occurrence heard = new Occurrence.Heard(new Event("switch"), values, Source.PANEL, 0, 1);
        String entry = EntryJson.of(
                        new HistoryEntry(1, Instant.EPOCH, heard, at, at, Outcome.HANDLED, "", null, Duration.ZERO))
                .toString();
        assertThat(new JsonMapper().readTree(entry).path("values").stringValue())
                .isEqualTo("level=NaN, most=Infinity");
    }
}
