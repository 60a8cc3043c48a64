package org.evoloop.statechart;

import static org.assertj.core.api.Assertions.assertThat;
import static org.evoloop.statechart.Draw.initial;
import static org.evoloop.statechart.Draw.region;
import static org.evoloop.statechart.Draw.state;

import java.time.temporal.ChronoUnit;
import java.util.List;
import org.junit.jupiter.api.Test;

class TimeUnitsTest {
    @Test
    void nothingButTheTimeTriggersChanges() {
        Arc drawn = new Arc(
                Place.NONE, "A", "A", List.of("after 2", "«spontaneous» stuck"), "g", List.of("x"), Arc.Kind.LOCAL, 3);
        Region top = new Region("", Place.NONE, region(initial("i"), state("A")).vertices(), List.of(drawn));
        Statechart chart =
                new Statechart("chart", Place.NONE, List.of(top), List.of("after 3"), Statechart.Semantics.SCXML);

        Statechart timed = TimeUnits.add(chart, ChronoUnit.SECONDS);

        Arc arc = timed.regions().get(0).arcs().get(0);
        assertThat(arc.triggers()).hasSize(2).first().isNotEqualTo("after 2");
        assertThat(arc.spontaneous()).containsExactly("stuck");
        assertThat(arc).usingRecursiveComparison().ignoringFields("triggers").isEqualTo(drawn);
        assertThat(timed.semantics()).isEqualTo(Statechart.Semantics.SCXML);
    }
}
