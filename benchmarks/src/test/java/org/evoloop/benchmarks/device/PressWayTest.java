package org.evoloop.benchmarks.device;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.evoloop.benchmarks.report.Figures;
import org.evoloop.benchmarks.report.Row;
import org.junit.jupiter.api.Test;

class PressWayTest {
    private static final Figures BARE =
            Figures.parse("direct p50 20\ndirect p99 100\nthreads p50 200\nthreads p99 1000\n");

    private static List<Row> rows(double median, double percentile99) {
        return PressWay.THREADS.rows(Figures.parse("press p50 " + median + "\npress p99 " + percentile99 + "\n"), BARE);
    }

    @Test
    void threadsAreHeldAgainstTheBareChainOfThreads() {
        List<Row> rows = rows(250, 1500);

        assertThat(rows).extracting(row -> row.goal().name()).containsOnly("by way of 3 bare threads");
        assertThat(rows).extracting(row -> row.goal().ratio(row.ours())).containsExactly(1.25, 1.5);
        assertThat(rows).allMatch(Row::reached);
        assertThat(rows.get(0).peers())
                .containsEntry("a byte sent back by its reader", 20.0)
                .containsEntry("by way of 3 bare threads", 200.0);
        assertThat(rows.get(1).peers()).containsEntry("a byte sent back by its reader", 100.0);
    }

    @Test
    void oneCarrierIsHeldAgainstTheReaderThatSendsTheByteBack() {
        List<Row> rows = PressWay.CARRIER.rows(Figures.parse("press p50 120\npress p99 600\n"), BARE);

        assertThat(rows).extracting(row -> row.goal().name()).containsOnly("a byte sent back by its reader");
        assertThat(rows).extracting(row -> row.goal().ratio(row.ours())).containsExactly(6.0, 6.0);
        assertThat(rows).allMatch(Row::reached);
    }

    @Test
    void moreIsTooMuch() {
        assertThat(rows(251, 1501)).noneMatch(Row::reached);
    }
}
