package org.evoloop.statechart;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.evoloop.statechart.Vertex.ChartState;
import org.evoloop.statechart.Vertex.FinalState;
import org.evoloop.statechart.Vertex.Kind;
import org.evoloop.statechart.Vertex.Pseudostate;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.junit.jupiter.api.Test;

/** Charts that are flat, and those that nearly are, become the same machine with and without exploration. */
class FlatChartTest {
    private static final int CHARTS = 20_000;
    private static final List<String> EVENTS =
            List.of("a", "b", "c", "d", "e", "«spontaneous» f", "«urgent» g", "<<urgent, spontaneous>> h");

    private static final List<String> KEYWORDS = List.of(
            "«device A» ", "«sends a, b» ", "«device A, sends c»", "«devise A» ", "«spontaneous» ", "«urgent» ");

    private final List<Vertex> vertices = new ArrayList<>();
    private final List<Arc> arcs = new ArrayList<>();

    @Test
    void shouldBecomeTheSameAsByExploration() {
        int flat = 0;
        int refused = 0;
        for (long seed = 1; seed <= CHARTS; seed++) {
            Statechart chart = draw(new Random(seed));
            Flattening actual = Flattening.of(chart);
            assertThat(description(actual))
                    .as("seed %d: %s", seed, chart)
                    .isEqualTo(description(Flattening.explored(chart)));
            flat += FlatChart.flatten(chart) == null ? 0 : 1;
            refused += actual.problems().isEmpty() ? 0 : 1;
        }
        assertThat(flat).as("flat charts").isBetween(CHARTS / 4, 3 * CHARTS / 4);
        assertThat(refused).as("charts with problems").isBetween(CHARTS / 20, CHARTS / 2);
    }

    private Statechart draw(Random random) {
        vertices.clear();
        arcs.clear();
        int states = 1 + random.nextInt(6);
        for (int state = 0; state < states; state++) {
            vertices.add(state(state, random));
        }
        vertices.add(random.nextInt(states), new Pseudostate("i", "", Place.NONE, Kind.INITIAL));
        arcs.add(arc("i", "s" + random.nextInt(states), List.of(), actions(random)));
        for (int count = random.nextInt(states + 2); count > 0; count--) {
            List<String> triggers = new ArrayList<>(List.of(one(EVENTS, random)));
            if (random.nextInt(5) == 0) {
                triggers.add(one(EVENTS, random));
            }
            String source = "s" + random.nextInt(states);
            arcs.add(arc(source, "s" + random.nextInt(states), triggers, actions(random)));
        }
        if (random.nextInt(3) == 0) {
            distort(random);
        }
        Region region = new Region("", Place.NONE, vertices, arcs);
        List<Region> regions = random.nextInt(50) == 0 ? List.of(region, region) : List.of(region);
        return new Statechart("chart", Place.NONE, regions, List.of("g", " ", "a"));
    }

    private static ChartState state(int number, Random random) {
        boolean strange = random.nextInt(60) == 0;
        return new ChartState(
                "s" + (strange ? random.nextInt(2) : number),
                (random.nextInt(20) == 0 ? one(KEYWORDS, random) : "")
                        + (random.nextInt(60) == 0 ? one(List.of("S0", "S1", " "), random) : "S" + number),
                Place.NONE,
                actions(random),
                actions(random),
                random.nextInt(60) == 0 ? List.of("hum") : List.of(),
                random.nextInt(60) == 0 ? List.of(arc("s" + number, "s" + number, List.of("g"), List.of())) : List.of(),
                random.nextInt(60) == 0 ? List.of("b") : List.of(),
                List.of(),
                List.of());
    }

    /** Adds something that not every flat chart has. */
    private void distort(Random random) {
        Arc any = one(arcs, random);
        switch (random.nextInt(9)) {
            case 0 -> arcs.add(with(any, any.target(), any.triggers(), "hot", Arc.Kind.EXTERNAL));
            case 1 -> arcs.add(with(any, any.target(), List.of("after 2 s"), "", Arc.Kind.EXTERNAL));
            case 2 -> arcs.add(with(any, any.target(), List.of("after a while"), "", Arc.Kind.EXTERNAL));
            case 3 -> arcs.add(with(any, any.target(), List.of(), "", Arc.Kind.EXTERNAL));
            case 4 -> arcs.add(with(any, any.target(), List.of("g"), "", Arc.Kind.LOCAL));
            case 5 -> arcs.add(with(any, one(List.of("i", "nowhere"), random), List.of("g"), "", Arc.Kind.EXTERNAL));
            case 6 -> arcs.add(with(any, any.target(), List.of("«spontanous» h"), "", Arc.Kind.EXTERNAL));
            case 7 -> vertices.add(new FinalState("end", "", Place.NONE));
            default -> vertices.add(new Pseudostate("i2", "", Place.NONE, one(List.of(Kind.values()), random)));
        }
    }

    private static Arc with(Arc arc, String target, List<String> triggers, String guard, Arc.Kind kind) {
        return new Arc(Place.NONE, arc.source(), target, triggers, guard, List.of(), kind);
    }

    private static Arc arc(String source, String target, List<String> triggers, List<String> effects) {
        return new Arc(Place.NONE, source, target, triggers, "", effects, Arc.Kind.EXTERNAL);
    }

    private static List<String> actions(Random random) {
        return random.nextInt(3) == 0 ? List.of("x" + random.nextInt(3)) : List.of();
    }

    private static <T> T one(List<T> some, Random random) {
        return some.get(random.nextInt(some.size()));
    }

    private static List<Object> description(Flattening flattening) {
        List<Object> all = new ArrayList<>(List.of(flattening.problems(), flattening.leaves()));
        if (flattening.problems().isEmpty()) {
            StateMachine machine = flattening.machine();
            all.addAll(List.of(
                    machine.name(),
                    machine.initial(),
                    machine.initialEffects(),
                    machine.transitions(),
                    List.copyOf(machine.events()),
                    machine.spontaneous()));
            for (State state : machine.states()) {
                all.addAll(List.of(
                        state,
                        machine.withoutMemory(state),
                        machine.paths(state),
                        machine.isEnd(state),
                        machine.activities(state),
                        machine.deferred(state),
                        String.valueOf(machine.deviceState(state)),
                        machine.inheritsDeviceState(state),
                        machine.sends(state)));
            }
        }
        return all;
    }
}
