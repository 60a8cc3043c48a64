package org.evoloop.statechart;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.evoloop.statechart.Draw.arc;
import static org.evoloop.statechart.Draw.chart;
import static org.evoloop.statechart.Draw.initial;
import static org.evoloop.statechart.Draw.named;
import static org.evoloop.statechart.Draw.pseudo;
import static org.evoloop.statechart.Draw.region;
import static org.evoloop.statechart.Draw.state;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.evoloop.statechart.Vertex.ChartState;
import org.evoloop.statechart.Vertex.Kind;
import org.evoloop.statemachine.ModelException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Charts without a flat machine or without a meaning are refused with the place and a remedy. */
class FlatteningRefusalTest {

    /** The chart: i to A, states A, B and C, where C has the regions {D, E} and {F}, and a pseudostate of each kind. */
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "A B e; A C e                 | two transitions leave state 'A' on event e",
                "A B e [g]; A C e [g]         | two transitions leave state 'A' on event e",
                "A B; A C                     | two transitions leave state 'A': ",
                "A gone e                     | a transition leads to 'gone', which is no vertex of the machine",
                "A i e                        | ends in an initial pseudostate",
                "i B                          | leaves the initial pseudostate 'i'",
                "A junction e                 | no transition leaves the junction 'junction'",
                "A choice e; choice B; choice C | two branches leave the choice 'choice'",
                "A choice e; choice B go      | has a trigger but does not leave a state",
                "A fork e; fork C.D [g]; fork C.F | must have no guard",
                "A fork e; fork C.D; fork C.E | two branches of the fork 'fork' end in one region",
                "A fork e; fork junction; junction A | does not end in a state",
                "C.D join e; C.F join x; join A | have different triggers",
                "i2 join; join A              | does not begin in a state",
                "terminate A                  | leaves a terminate",
                "A B tm(2)                    | time trigger 'tm(2)' has no unit",
                "A A; A B e                   | transitions without events lead in an endless circle through state 'A'",
                "A choice e; choice junction; junction choice | transitions lead in a circle through the choice 'choice'",
                "A C e; C.D A x; C.F B x      | one event triggers two transitions in different regions",
                "A B [g]                      | the state in which the machine starts depends on the guard [g]",
            })
    void shouldRefuse(String arcs, String problem) {
        Region one = region(initial("i2"), state("C.D"), state("C.E"), pseudo("history", Kind.DEEP_HISTORY));
        List<Vertex> vertices = new ArrayList<>(
                List.of(initial("i"), state("A"), state("B"), state("C", one, region(initial("i3"), state("C.F")))));
        Stream.of(Kind.JUNCTION, Kind.CHOICE, Kind.FORK, Kind.JOIN, Kind.TERMINATE)
                .filter(kind -> arcs.contains(word(kind)))
                .forEach(kind -> vertices.add(pseudo(word(kind), kind)));
        Stream<Arc> always = Stream.of("i A", "i2 C.D", "i3 C.F").map(Draw::arc);
        Arc[] all = Stream.concat(always, Arrays.stream(arcs.split("; ")).map(Draw::arc))
                .toArray(Arc[]::new);

        List<Problem> problems = Flattening.of(chart(region(vertices.toArray(new Vertex[0])), all))
                .problems();

        assertThat(problems)
                .extracting(Problem::message)
                .anySatisfy(message -> assertThat(message).contains(problem));
        assertThat(problems).allSatisfy(found -> assertThat(found.remedy()).isNotBlank());
        assertThat(problems).allSatisfy(found -> assertThat(found.place()).isNotEqualTo(Place.NONE));
    }

    private static String word(Kind kind) {
        return kind.name().toLowerCase(java.util.Locale.ROOT);
    }

    @Test
    void shouldNameBothOfTwoTransitionsWithTheirLines() {
        Problem problem = Flattening.of(
                        chart(region(initial("i"), state("A"), state("B")), arc("i A"), arc("A B e"), arc("A A e")))
                .problems()
                .get(0);

        assertThat(problem)
                .hasToString("line 7: two transitions leave state 'A' on event e:"
                        + " transition from state 'A' to state 'B' on 'e' (line 7, id id-A) and"
                        + " transition from state 'A' to state 'A' on 'e' (line 7, id id-A);"
                        + " remove one of them or give it another event or guard");
    }

    @Test
    void shouldRefuseTheSameNameTwiceInOneRegionAndStatesWithoutName() {
        Statechart chart = chart(region(initial("i"), named("1", "On"), named("2", "On"), named("3", " ")), arc("i 1"));

        assertThat(Flattening.of(chart).problems())
                .extracting(Problem::toString)
                .containsExactly(
                        "line 7: state without a name (id 'id-3'); give it one",
                        "line 7: state 'On' has the name of the state in line 7, id id-1 (id 'id-2'); rename one of them");
        assertThatThrownBy(() -> Flattening.flatten(chart))
                .isInstanceOf(ModelException.class)
                .hasMessageStartingWith("state machine 'chart': line 7: ");
    }

    @Test
    void shouldRefuseARegionThatIsEnteredButDoesNotSayWhere() {
        Statechart chart = chart(
                region(initial("i"), state("A"), state("C", region(state("D")))),
                arc("i A"),
                arc("A C in"),
                arc("A D over"));

        assertThat(Flattening.of(chart).problems())
                .extracting(Problem::toString)
                .containsExactly("line 7: state 'C' is entered but has no initial pseudostate (id 'id-C');"
                        + " draw one, or end the transition at a state in it");
    }

    @Test
    void shouldRefuseTimeTriggersThatAreDeferred() {
        ChartState deferring = new ChartState(
                "A",
                "A",
                new Place("a", 3),
                List.of(),
                List.of(),
                List.of(),
                List.of(),
                List.of("tm(2s)"),
                List.of(),
                List.of());

        assertThat(Flattening.of(chart(region(initial("i"), deferring), arc("i A")))
                        .problems())
                .extracting(Problem::message)
                .containsExactly("state 'A' defers the time trigger 'tm(2s)'");
    }

    @Test
    void shouldRefuseWhatIsTooLargeWithOneMessage() {
        List<Region> regions = new ArrayList<>();
        List<Arc> arcs = new ArrayList<>(List.of(arc("i A")));
        for (int i = 0; i < 3; i++) {
            List<Vertex> vertices = new ArrayList<>(List.of(initial("i" + i)));
            arcs.add(arc("i" + i + " s" + i + "-0"));
            for (int k = 0; k < 50; k++) {
                vertices.add(state("s" + i + "-" + k));
                arcs.add(arc("s" + i + "-" + k + " s" + i + "-" + (k + 1) % 50 + " e" + i));
            }
            regions.add(region(vertices.toArray(new Vertex[0])));
        }
        Statechart chart =
                chart(region(initial("i"), state("A", regions.toArray(new Region[0]))), arcs.toArray(new Arc[0]));

        assertThat(Flattening.of(chart).problems())
                .extracting(Problem::message)
                .containsExactly("the flat machine has more than 100000 states");
    }

    @Test
    void shouldRefuseAnUnrealisticDepthWithoutOverflow() {
        Vertex inner = state("s");
        for (int level = 0; level < 100_000; level++) {
            inner = state("s" + level, region(inner));
        }

        // The transition leads to a state that is too deep, which is no second problem.
        assertThat(Flattening.of(chart(region(initial("i"), inner), arc("i s5")))
                        .problems())
                .extracting(Problem::message)
                .containsExactly("states are nested deeper than 300");
    }

    @Test
    void shouldRefuseAnEmptyChart() {
        assertThat(Flattening.of(chart(region())).problems())
                .extracting(Problem::toString)
                .containsExactly(
                        "line 1: the machine has no states (id 'chart'); draw an initial pseudostate and states");
    }
}
