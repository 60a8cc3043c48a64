package org.evoloop.evolution;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.evoloop.statemachine.State;
import org.junit.jupiter.api.Test;

class DecisionCellsTest {
    private static Decision decision(String state) {
        Configuration at = new Configuration(new State(state), new State(state));
        return new Decision.NotAcceptable(at, at, List.of());
    }

    @Test
    void shouldKeepApartCellsWhosePlacesDifferByMoreThanAnInt() {
        int width = 1 << 20;
        DecisionCells cells = new DecisionCells(width);
        // 4,096 rows of a million cells are 2^32 cells.
        int[] situations = {0, 1, 2_047, 2_048, 4_095, 4_096, 8_192, 1_000_000};
        int[] events = {0, 1, width - 1};
        for (int situation : situations) {
            cells.open(situation);
            for (int event : events) {
                assertThat(cells.get(situation, event))
                        .as("%d, %d", situation, event)
                        .isNull();
                cells.put(situation, event, decision(situation + " " + event));
            }
        }
        cells.link(decision -> decision.before().original().name().length());
        for (int situation : situations) {
            for (int event : events) {
                String name = situation + " " + event;
                assertThat(cells.get(situation, event)).as(name).isEqualTo(decision(name));
                assertThat(cells.after(situation, event)).as(name).isEqualTo(name.length());
            }
        }
    }

    @Test
    void shouldKeepEveryDecisionWhenRowsGiveWayToHashing() {
        int width = 1_000;
        DecisionCells cells = new DecisionCells(width);
        // The cells of the last situations no longer fit in rows.
        for (int situation = 0; situation < 10_000; situation += 7) {
            cells.open(situation);
            cells.put(situation, situation % width, decision("S" + situation));
        }
        cells.link(decision -> decision.after().original().name().hashCode());

        for (int situation = 0; situation < 10_000; situation++) {
            Decision expected = situation % 7 == 0 ? decision("S" + situation) : null;
            assertThat(cells.get(situation, situation % width)).isEqualTo(expected);
            assertThat(cells.after(situation, situation % width))
                    .isEqualTo(expected == null ? situation : ("S" + situation).hashCode());
        }
    }

    @Test
    void shouldSayThatADecisionLeadsNowhereKnownUntilItIsLinked() {
        DecisionCells cells = new DecisionCells(3);
        cells.open(1);
        cells.put(1, 2, decision("S"));

        assertThat(cells.after(1, 2)).isEqualTo(DecisionCells.UNKNOWN);
        assertThat(cells.after(1, 1)).isEqualTo(1);
    }
}
