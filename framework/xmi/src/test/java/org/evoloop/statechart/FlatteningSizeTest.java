package org.evoloop.statechart;

import static org.assertj.core.api.Assertions.assertThat;
import static org.evoloop.statechart.Draw.arc;
import static org.evoloop.statechart.Draw.chart;
import static org.evoloop.statechart.Draw.initial;
import static org.evoloop.statechart.Draw.pseudo;
import static org.evoloop.statechart.Draw.region;
import static org.evoloop.statechart.Draw.state;

import java.util.ArrayList;
import java.util.List;
import org.evoloop.statechart.Vertex.Kind;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The size of the product of parallel regions is checked before it is built. */
@Timeout(60)
class FlatteningSizeTest {

    /** @param event the event of all regions; if it contains {@code #}, each region has its own */
    private static Statechart lamps(int regions, String event) {
        List<Region> side = new ArrayList<>();
        List<Arc> arcs = new ArrayList<>(List.of(arc("i P")));
        for (int i = 0; i < regions; i++) {
            side.add(region(initial("i" + i), state("Off" + i), state("On" + i)));
            String own = event.replace("#", String.valueOf(i));
            arcs.add(arc("i" + i + " Off" + i));
            arcs.add(arc("Off" + i + " On" + i + " " + own));
            arcs.add(arc("On" + i + " Off" + i + " " + own));
        }
        return chart(region(initial("i"), state("P", side.toArray(new Region[0]))), arcs.toArray(new Arc[0]));
    }

    @ParameterizedTest
    @CsvSource({
        "16, up to 65536 states and 1048576 transitions",
        "30, up to 1073741824 states and 32212254720 transitions",
        "5000, up to 10^1505 states and 10^1508 transitions"
    })
    void shouldRefuseWhatWouldBeTooLargeWithItsSize(int regions, String size) {
        assertThat(Flattening.of(lamps(regions, "e#")).problems())
                .singleElement()
                .satisfies(problem -> {
                    assertThat(problem.message())
                            .contains(
                                    size,
                                    "state 'P' has " + regions + " regions side by side",
                                    "at most 100000 states and 1000000 transitions");
                    assertThat(problem.place().id()).isEqualTo("id-P");
                    assertThat(problem.remedy()).contains("fewer regions");
                });
    }

    /** 2 to the 200th combinations, only two of which are reachable. */
    @Test
    void shouldFlattenRegionsThatChangeTogether() {
        Flattening flattening = Flattening.of(lamps(200, "e"));

        assertThat(flattening.problems()).isEmpty();
        assertThat(flattening.machine().states()).hasSize(2);
    }

    @Test
    void shouldFlattenWhatIsLargeAndNotTooLarge() {
        Flattening flattening = Flattening.of(lamps(10, "e#"));

        assertThat(flattening.machine().states()).hasSize(1024);
        assertThat(flattening.machine().transitions()).hasSize(10_240);
    }

    /** Each history remembers one of 50 states or none. */
    @Test
    void shouldCountWhatHistoriesRemember() {
        List<Vertex> vertices = new ArrayList<>(List.of(initial("i"), state("Start")));
        List<Arc> arcs = new ArrayList<>(List.of(arc("i Start")));
        for (int c = 0; c < 5; c++) {
            List<Vertex> inner = new ArrayList<>(List.of(pseudo("h" + c, Kind.SHALLOW_HISTORY)));
            for (int s = 0; s < 50; s++) {
                inner.add(state("S" + c + "." + s));
                arcs.add(arc("S" + c + "." + s + " S" + c + "." + (s + 1) % 50 + " next"));
            }
            vertices.add(state("C" + c, region(inner.toArray(new Vertex[0]))));
            arcs.add(arc("h" + c + " S" + c + ".0"));
            arcs.add(arc("C" + c + " Start leave"));
            arcs.add(arc("Start h" + c + " go" + c));
        }

        assertThat(Flattening.of(chart(region(vertices.toArray(new Vertex[0])), arcs.toArray(new Arc[0])))
                        .problems())
                .singleElement()
                .satisfies(problem -> assertThat(problem.message()).contains("up to " + 251L * 51 * 51 * 51 * 51 * 51));
    }
}
