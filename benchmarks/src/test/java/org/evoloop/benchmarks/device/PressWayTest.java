package org.evoloop.benchmarks.device;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.evoloop.benchmarks.report.Figures;
import org.evoloop.benchmarks.report.Row;
import org.junit.jupiter.api.Test;

class PressWayTest {
    private static List<Row> rows(int carrier, int threads, int byBatch, int perIntent) {
        return PressWay.rows(
                Figures.parse(String.format("""
                BARE p50 20
                BARE p99 100
                BARE_THREADS p50 200
                BARE_THREADS p99 1000
                CARRIER p50 %d
                CARRIER p99 %d
                THREADS p50 %d
                THREADS p99 %d
                JOURNAL_BY_BATCH p50 %d
                JOURNAL_PER_INTENT p50 %d
                slow pages 0.5
                """, carrier, 5 * carrier, threads, 6 * threads, byBatch, perIntent)));
    }

    @Test
    void eachWayIsComparedWithTheMostSimilarBareOneAndAJournalWithNone() {
        List<Row> rows = rows(120, 250, 132, 6000);

        assertThat(rows)
                .extracting(row -> row.goal().name())
                .containsExactly(
                        "a byte sent back by its reader",
                        "a byte sent back by its reader",
                        "by way of 3 bare threads",
                        "by way of 3 bare threads",
                        "without a journal",
                        "without a journal");
        assertThat(rows)
                .extracting(row -> row.goal().ratio(row.ours()))
                .containsExactly(6.0, 6.0, 1.25, 1.5, 1.1, 50.0);
        assertThat(rows).allMatch(Row::reached);
    }

    @Test
    void moreIsTooMuch() {
        assertThat(rows(121, 251, 134, 6051)).noneMatch(Row::reached);
    }
}
