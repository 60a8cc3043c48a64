package org.evoloop.benchmarks.ring;

import static org.assertj.core.api.Assertions.assertThat;

import org.evoloop.benchmarks.report.Figures;
import org.evoloop.benchmarks.report.Row;
import org.junit.jupiter.api.Test;

class FloodTurnsTest {
    private static Row row(double ours) {
        StringBuilder found = new StringBuilder("flood " + ours + "\n");
        for (HandOff.Kind kind : HandOff.Kind.values()) {
            found.append(kind).append(kind == HandOff.Kind.YIELDING_SLOT ? " 100000\n" : " 2000\n");
        }
        return FloodTurns.row(Figures.parse(found.toString()));
    }

    @Test
    void theBestBareRingCounts() {
        Row row = row(70_000);

        assertThat(row.goal().name()).isEqualTo("YieldingSlot");
        assertThat(row.goal().ratio(row.ours())).isEqualTo(0.7);
        assertThat(row.reached()).isTrue();
        assertThat(row.peers()).hasSize(HandOff.Kind.values().length).containsEntry("SynchronousQueue", 2000.0);
    }

    @Test
    void aLowerRateIsNotEnough() {
        assertThat(row(69_000).reached()).isFalse();
    }
}
