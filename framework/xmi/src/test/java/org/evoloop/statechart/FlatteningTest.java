package org.evoloop.statechart;

import static org.assertj.core.api.Assertions.assertThat;
import static org.evoloop.statechart.Draw.arc;
import static org.evoloop.statechart.Draw.chart;
import static org.evoloop.statechart.Draw.doing;
import static org.evoloop.statechart.Draw.end;
import static org.evoloop.statechart.Draw.initial;
import static org.evoloop.statechart.Draw.lines;
import static org.evoloop.statechart.Draw.local;
import static org.evoloop.statechart.Draw.named;
import static org.evoloop.statechart.Draw.pseudo;
import static org.evoloop.statechart.Draw.region;
import static org.evoloop.statechart.Draw.state;
import static org.evoloop.statechart.Draw.with;

import java.util.ArrayList;
import java.util.List;
import org.evoloop.statechart.Vertex.Kind;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.junit.jupiter.api.Test;

class FlatteningTest {

    @Test
    void aFlatMachineStaysAsItIsUnreachableStatesIncluded() {
        Statechart chart = chart(
                region(state("B"), initial("i"), state("A"), state("lost")),
                arc("i A / hello"),
                arc("A B go"),
                arc("B A back / x"),
                arc("lost A home"));

        StateMachine flat = Flattening.flatten(chart);

        assertThat(flat.states()).extracting(State::name).containsExactly("B", "A", "lost");
        assertThat(flat.initial()).isEqualTo(new State("A"));
        assertThat(flat.initialEffects()).containsExactly("hello", "+A");
        assertThat(lines(flat))
                .containsExactly("B --back--> A / -B x +A", "A --go--> B / -A +B", "lost --home--> A / -lost +A");
    }

    @Test
    void statesOfTheSameNameInTwoCompositesStayApart() {
        Statechart chart = chart(
                region(
                        initial("i"),
                        named("1", "On", region(initial("j"), named("11", "Idle"), named("12", "Busy"))),
                        named("2", "Off", region(initial("k"), named("21", "Idle")))),
                arc("i 1"),
                arc("j 11"),
                arc("k 21"),
                arc("11 12 work"),
                arc("1 2 off"));

        assertThat(lines(Flattening.flatten(chart)))
                .containsExactly("On.Idle --work--> Busy", "On.Idle --off--> Off.Idle", "Busy --off--> Off.Idle");
    }

    @Test
    void guardedTransitionsBetweenTheSameStatesAllStayInTheirOrderAndElseComesLast() {
        Statechart chart = chart(
                region(initial("i"), state("A"), state("B")),
                arc("i A"),
                arc("A B go [else] / e"),
                arc("A B go / plain"),
                arc("A B go [g] / 1"),
                arc("A B go [h] / 2"));

        assertThat(lines(Flattening.flatten(chart)))
                .containsExactly("A --go [g]--> B / -A 1 +B", "A --go [h]--> B / -A 2 +B", "A --go--> B / -A plain +B");
    }

    @Test
    void aBranchInWhichNothingHappensHidesTheOnesBehindIt() {
        Statechart chart = chart(
                region(initial("i"), state("A"), state("B"), pseudo("c", Kind.JUNCTION), pseudo("d", Kind.CHOICE)),
                arc("i A"),
                arc("A c go"),
                arc("c d [g]"),
                arc("c B [else]"),
                arc("d B [h] / both"));

        assertThat(lines(Flattening.flatten(chart)))
                .containsExactly("A --go [g] [h]--> B / -A both +B", "A --go [g]--> A internal", "A --go--> B / -A +B");
    }

    @Test
    void regionsAreEnteredAndLeftInTheirOrderAndInnerBeforeOuter() {
        Statechart chart = chart(
                region(
                        initial("i"),
                        state("A", region(initial("j"), state("B")), region(initial("k"), state("C"), state("D")))),
                arc("i A"),
                arc("j B / b"),
                arc("k C / c"),
                arc("B B e / self"),
                arc("C D e / on"),
                arc("A A e"),
                arc("A A again / again"));

        StateMachine flat = Flattening.flatten(chart);

        assertThat(flat.initialEffects()).containsExactly("+A", "b", "+B", "c", "+C");
        assertThat(lines(flat))
                .containsExactly(
                        "(B, C) --e--> (B, D) / -B self +B -C on +D",
                        "(B, C) --again--> (B, C) / -B -C -A again +A b +B c +C",
                        "(B, D) --e--> (B, D) / -B self +B",
                        "(B, D) --again--> (B, C) / -B -D -A again +A b +B c +C");
    }

    @Test
    void aLocalTransitionDoesNotLeaveTheOuterOfItsEnds() {
        Statechart chart = chart(
                region(initial("i"), state("A", region(initial("j"), state("B"), state("C")))),
                arc("i A"),
                arc("j B"),
                arc("B C next"),
                local("C A up / rise"),
                local("A A again / turn"),
                local("C C stay / hold"));

        assertThat(lines(Flattening.flatten(chart)))
                .containsExactly(
                        "B --next--> C / -B +C",
                        "B --again--> B / -B turn +B",
                        "C --up--> B / -C rise +B",
                        "C --stay--> C / hold internal",
                        "C --again--> B / -C turn +B");
    }

    @Test
    void aLocalTransitionDoesNotLeaveItsSource() {
        Statechart chart = chart(
                region(initial("i"), state("A", region(initial("j"), state("B"), state("C")))),
                arc("i A"),
                arc("j B"),
                arc("A C external"),
                local("A C local"));

        assertThat(lines(Flattening.flatten(chart)))
                .startsWith("B --external--> C / -B -A +A +C", "B --local--> C / -B +C");
    }

    @Test
    void nothingHappensBehindTheEndOfTheMachine() {
        Statechart chart = chart(
                region(
                        initial("i"),
                        state("A", region(initial("j"), state("B"), pseudo("x", Kind.TERMINATE))),
                        end("f")),
                arc("i A"),
                arc("j B"),
                arc("B x kill / killed"),
                arc("A f stop"));

        StateMachine flat = Flattening.flatten(chart);

        assertThat(lines(flat)).containsExactly("B --kill--> x / -B killed", "B --stop--> f / -B -A");
        assertThat(flat.transitionsFrom(new State("x"))).isEmpty();
        assertThat(flat.transitionsFrom(new State("f"))).isEmpty();
    }

    @Test
    void anEntryPointWithoutTransitionEntersByDefault() {
        Statechart chart = chart(
                region(
                        initial("i"),
                        state("A"),
                        with(state("C", region(initial("j"), state("D"), state("E"))), pseudo("p", Kind.ENTRY_POINT))),
                arc("i A"),
                arc("j D"),
                arc("D E next"),
                arc("A p in"));

        assertThat(lines(Flattening.flatten(chart))).contains("A --in--> D / -A +C +D");
    }

    @Test
    void aStateIsCompleteWhenAllItsRegionsAre() {
        Statechart chart = chart(
                region(
                        initial("i"),
                        state(
                                "A",
                                region(initial("j"), state("B"), end("f")),
                                region(initial("k"), state("C"), end("g"))),
                        state("D")),
                arc("i A"),
                arc("j B"),
                arc("k C"),
                arc("B f e"),
                arc("C g e2"),
                arc("A D / done"));

        assertThat(lines(Flattening.flatten(chart)))
                .contains("(B, g) --e--> D / -B -A done +D", "(f, C) --e2--> D / -C -A done +D");
    }

    @Test
    void theEndOfADoActivityIsAnEvent() {
        Statechart chart = chart(
                region(initial("i"), doing("A", "brew"), state("B"), state("C")),
                arc("i A"),
                arc("A B [hot]"),
                arc("A C stop"));

        StateMachine flat = Flattening.flatten(chart);

        assertThat(flat.activities(flat.initial())).containsExactly("brew");
        assertThat(lines(flat))
                .containsExactly(
                        "A --stop--> C / +C",
                        "A --completion(A) [hot]--> B / +B",
                        "A --completion(A)--> A [done A]",
                        "A [done A] --stop--> C / +C");
        assertThat(flat.transition(flat.initial(), new Event("completion(A)"))
                        .orElseThrow()
                        .keeps())
                .containsExactly("brew");
    }

    @Test
    void timersOfStatesAroundEachOtherHaveTheirOwnEvents() {
        Statechart chart = chart(
                region(initial("i"), state("A", region(initial("j"), state("B"), state("C"))), state("D")),
                arc("i A"),
                arc("j B"),
                arc("A D tm(2s)"),
                arc("B C tm(2s)"),
                arc("D A after(1s)"));

        StateMachine flat = Flattening.flatten(chart);

        assertThat(lines(flat))
                .containsExactly(
                        "B --tm(2s) in B--> C / -B +C",
                        "B --tm(2s) in A--> D / -B -A +D",
                        "C --tm(2s) in A--> D / -C -A +D",
                        "D --after(1s)--> B / -D +A +B");
        assertThat(flat.transition(new State("B"), new Event("tm(2s) in B"))
                        .orElseThrow()
                        .keeps())
                .containsExactly("tm(2s) in A");
        assertThat(new Event("tm(2s) in A").timeTrigger()).hasValue(java.time.Duration.ofSeconds(2));
    }

    @Test
    void whatAHistoryRemembersSplitsStatesOnlyWhereItMatters() {
        Region inner = region(initial("j"), state("B"), state("C"), pseudo("h", Kind.SHALLOW_HISTORY));
        Statechart matters = chart(
                region(initial("i"), state("A", inner), state("off")),
                arc("i off"),
                arc("j B"),
                arc("off h on"),
                arc("B C next"),
                arc("A off off"));
        Statechart does = chart(
                region(initial("i"), state("A", inner), state("off"), state("gone")),
                arc("i off"),
                arc("j B"),
                arc("off h on"),
                arc("B C next"),
                arc("A gone off"));

        assertThat(Flattening.flatten(matters).states())
                .extracting(State::name)
                .containsExactly("B", "C", "off", "off [history C]");
        assertThat(Flattening.flatten(does).states()).extracting(State::name).containsExactly("B", "C", "off", "gone");
    }

    @Test
    void eachFlatStateShowsWhatIsActiveInIt() {
        Statechart chart = chart(
                region(initial("i"), state("A", region(initial("j"), state("B")), region(initial("k"), state("C")))),
                arc("i A"),
                arc("j B"),
                arc("k C"));

        assertThat(Flattening.of(chart).leaves().get(new State("(B, C)")))
                .extracting(Vertex::key)
                .containsExactly("B", "C");
    }

    @Test
    void threeHundredLevelsAndTenThousandCompletionsInARow() {
        Vertex inner = state("s0");
        List<Arc> arcs = new ArrayList<>();
        for (int level = 1; level < 300; level++) {
            arcs.add(arc("i" + level + " s" + (level - 1)));
            inner = state("s" + level, region(initial("i" + level), inner));
        }
        arcs.add(arc("i s299"));
        arcs.add(arc("s0 c0 go"));
        List<Vertex> vertices = new ArrayList<>(List.of(initial("i"), inner));
        for (int i = 0; i < 10_000; i++) {
            vertices.add(state("c" + i));
            arcs.add(arc("c" + i + " " + (i == 9_999 ? "rest" : "c" + (i + 1))));
        }
        vertices.add(state("rest"));

        StateMachine flat =
                Flattening.flatten(chart(region(vertices.toArray(new Vertex[0])), arcs.toArray(new Arc[0])));

        assertThat(flat.states()).extracting(State::name).containsExactly("s0", "rest");
        assertThat(flat.transitions().get(0).effects()).hasSize(300 + 20_000 + 1);
    }

    @Test
    void tenThousandStatesAndAHundredThousandTransitionsStayAsTheyAre() {
        List<Vertex> vertices = new ArrayList<>(List.of(initial("i")));
        List<Arc> arcs = new ArrayList<>(List.of(arc("i s0")));
        for (int i = 0; i < 10_000; i++) {
            vertices.add(named("s" + i, "S" + i));
            for (int event = 0; event < 10; event++) {
                arcs.add(arc("s" + i + " s" + (i + event) % 10_000 + " e" + event));
            }
        }

        StateMachine flat =
                Flattening.flatten(chart(region(vertices.toArray(new Vertex[0])), arcs.toArray(new Arc[0])));

        assertThat(flat.states()).hasSize(10_000);
        assertThat(flat.transitions()).hasSize(100_000);
        assertThat(flat.nextState(new State("S9999"), new Event("e3"))).hasValue(new State("S2"));
    }
}
