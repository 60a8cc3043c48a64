package org.evoloop.statechart;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.evoloop.statechart.Draw.arc;
import static org.evoloop.statechart.Draw.chart;
import static org.evoloop.statechart.Draw.initial;
import static org.evoloop.statechart.Draw.lines;
import static org.evoloop.statechart.Draw.pseudo;
import static org.evoloop.statechart.Draw.region;
import static org.evoloop.statechart.Draw.state;
import static org.evoloop.statechart.Draw.with;

import java.util.ArrayList;
import java.util.List;
import org.evoloop.statechart.Vertex.ChartState;
import org.evoloop.statechart.Vertex.Kind;
import org.junit.jupiter.api.Test;

/** Regions side by side: how they are entered and left, and which transitions are taken together. */
class OrthogonalTest {
    private static ChartState twoRegions() {
        return state(
                "P", region(initial("ix"), state("x"), state("x2")), region(initial("iy"), state("y"), state("y2")));
    }

    private static List<String> flat(ChartState parallel, String... arcs) {
        return lines(Flattening.flatten(drawn(parallel, arcs)));
    }

    private static Statechart drawn(ChartState parallel, String... arcs) {
        List<Arc> all = new ArrayList<>(List.of(arc("ix x"), arc("iy y"), arc("i A")));
        List.of(arcs).forEach(text -> all.add(arc(text)));
        return chart(region(initial("i"), state("A"), parallel), all.toArray(new Arc[0]));
    }

    @Test
    void aForkInsideAStateIsEnteredFromOutsideWithThatState() {
        Statechart chart = chart(
                region(
                        initial("i"),
                        state("A"),
                        state("B", region(initial("j"), pseudo("f", Kind.FORK), twoRegions()))),
                arc("i A"),
                arc("j P"),
                arc("ix x"),
                arc("iy y"),
                arc("A f e / t"),
                arc("f x2"),
                arc("f y2"),
                arc("x2 A back"));

        assertThat(lines(Flattening.flatten(chart)))
                .containsExactly("A --e--> (x2, y2) / -A t +B +P +x2 +y2", "(x2, y2) --back--> A / -x2 -y2 -P -B +A");
    }

    @Test
    void anEntryPointMayLeadIntoSeveralRegions() {
        ChartState parallel = with(twoRegions(), pseudo("en", Kind.ENTRY_POINT));

        assertThat(flat(parallel, "A en e / t", "en x2 / u", "en y2 / v"))
                .contains("A --e--> (x2, y2) / -A t +P u v +x2 +y2");
        assertThat(flat(parallel, "A en e / t", "en y2 / v")).contains("A --e--> (x, y2) / -A t +P v +y2 +x");
    }

    @Test
    void anInternalTransitionConflictsWithOneThatLeavesItsState() {
        ChartState parallel = state(
                "P", region(initial("ix"), state("x")), region(initial("iy"), internal(state("y"), "d", "inside")));

        assertThat(Flattening.of(drawn(parallel, "A P e", "x A d / t")).problems())
                .singleElement()
                .asString()
                .contains("of which only one can be taken");
        assertThat(flat(parallel, "A P e", "x A d [g] / t"))
                .contains("(x, y) --d [g]--> A / -x -y -P t +A", "(x, y) --d--> (x, y) / inside internal");
        assertThat(flat(parallel, "A P e", "x x d / t")).contains("(x, y) --d--> (x, y) / -x t +x inside");
    }

    private static ChartState internal(ChartState state, String event, String effect) {
        return new ChartState(
                state.key(),
                state.name(),
                state.place(),
                state.entry(),
                state.exit(),
                state.doActivities(),
                List.of(new Arc(
                        Place.NONE, state.key(), state.key(), List.of(event), "", List.of(effect), Arc.Kind.INTERNAL)),
                state.deferred(),
                state.regions(),
                state.connections());
    }

    @Test
    void ofConflictingTransitionsWithOneOutcomeAnyIsTaken() {
        assertThat(flat(twoRegions(), "A P e", "x A d / t", "y A d / t")).contains("(x, y) --d--> A / -x -y -P t +A");
    }

    @Test
    void ofConflictingTransitionsWithDifferentOutcomesTheFirstIsTakenOnlyIfOneHasAGuard() {
        assertThat(Flattening.of(drawn(twoRegions(), "A P e", "x A d / t", "y A d / u"))
                        .problems())
                .singleElement()
                .asString()
                .contains("one event triggers two transitions in different regions of which only one can be taken");
        assertThat(flat(twoRegions(), "A P e", "x A d [g] / t", "y y2 d"))
                .contains("(x, y) --d [g]--> A / -x -y -P t +A", "(x, y) --d--> (x, y2) / -y +y2");
    }

    @Test
    void aConflictThatNeverHappensIsNone() {
        assertThat(flat(twoRegions(), "A P e", "x A d", "y2 y d / t")).contains("(x, y) --d--> A / -x -y -P +A");
        assertThat(Flattening.of(drawn(twoRegions(), "A P e", "x A d", "y2 y d / t", "y y2 f"))
                        .problems())
                .hasSize(1);
    }

    @Test
    void noMachineIsEverInNoState() {
        Net net = NetBuilder.build(drawn(twoRegions(), "A P e"), new ArrayList<>());
        ActiveStates active = new ActiveStates(net);

        assertThatThrownBy(active::snapshot).hasMessage("the machine would be in no state of the machine");
        active.add(net.nodes().stream()
                .filter(node -> node.simpleName().equals("P"))
                .findFirst()
                .orElseThrow());
        assertThatThrownBy(active::snapshot).hasMessage("the machine would be in no state of region of state 'P'");
    }
}
