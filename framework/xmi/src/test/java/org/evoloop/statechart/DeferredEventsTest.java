package org.evoloop.statechart;

import static org.assertj.core.api.Assertions.assertThat;
import static org.evoloop.statechart.Draw.arc;
import static org.evoloop.statechart.Draw.chart;
import static org.evoloop.statechart.Draw.initial;
import static org.evoloop.statechart.Draw.pseudo;
import static org.evoloop.statechart.Draw.region;

import java.util.List;
import java.util.Set;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.DecisionTable;
import org.evoloop.evolution.DeviceEvents;
import org.evoloop.evolution.ModelPair;
import org.evoloop.statechart.Vertex.ChartState;
import org.evoloop.statechart.Vertex.Kind;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.junit.jupiter.api.Test;

/** Which events are deferred. */
class DeferredEventsTest {
    private static final State B = new State("B");
    private static final State C = new State("C");
    private static final State D = new State("D");
    private static final Event E = new Event("e");

    private static ChartState deferring(String name, String event, Region... regions) {
        return new ChartState(
                name,
                name,
                Place.NONE,
                List.of(),
                List.of(),
                List.of(),
                List.of(),
                List.of(event),
                List.of(regions),
                List.of());
    }

    @Test
    void aTransitionFurtherInGoesFirstAndOneAroundDoesNot() {
        StateMachine flat = Flattening.flatten(chart(
                region(
                        initial("i"),
                        Draw.state(
                                "O",
                                region(
                                        initial("h"),
                                        deferring("A", "e", region(initial("j"), Draw.state("B"), Draw.state("C"))),
                                        Draw.state("D")))),
                arc("i O"),
                arc("h A"),
                arc("j B"),
                arc("B C e"),
                arc("A D done"),
                arc("O O e")));

        assertThat(flat.defers(B, E)).isFalse();
        assertThat(flat.defers(C, E)).isTrue();
        assertThat(flat.transition(C, E)).isEmpty();
        assertThat(flat.defers(D, E)).isFalse();
        assertThat(flat.nextState(D, E)).contains(B);
        assertThat(flat.deferred(C)).containsExactly(E);
    }

    @Test
    void aRegionBesideMayConsumeTheEvent() {
        StateMachine flat = Flattening.flatten(chart(
                region(
                        initial("i"),
                        Draw.state(
                                "O",
                                region(initial("j"), deferring("A", "e")),
                                region(initial("k"), Draw.state("C"), Draw.state("D")))),
                arc("i O"),
                arc("j A"),
                arc("k C"),
                arc("C D e")));

        assertThat(flat.defers(new State("(A, C)"), E)).isFalse();
        assertThat(flat.defers(new State("(A, D)"), E)).isTrue();
    }

    @Test
    void aTransitionWhoseGuardDoesNotHoldDoesNotCount() {
        StateMachine flat = Flattening.flatten(chart(
                region(initial("i"), deferring("B", "e"), Draw.state("C"), pseudo("x", Kind.CHOICE)),
                arc("i B"),
                arc("B x e [g]"),
                arc("x C [h]")));

        assertThat(flat.defers(B, new Event("e", List.of("g", "h")))).isFalse();
        assertThat(flat.defers(B, E)).isTrue();
    }

    @Test
    void theNewModelSaysWhatWaits() {
        StateMachine device = StateMachine.named("original")
                .initial("B")
                .transition("B", "e", "C")
                .transition("C", "f", "B")
                .build();
        StateMachine evolved = StateMachine.named("new")
                .initial("B")
                .transition("B", "e", "C")
                .transition("C", "f", "B")
                .defers("C", E)
                .build();
        DecisionTable table =
                DecisionTable.compile(new ModelPair(device, evolved), new DeviceEvents(device.triggers(), Set.of()));

        assertThat(table.defers(new Configuration(B, B), E)).isFalse();
        assertThat(table.defers(new Configuration(C, C), E)).isTrue();
        assertThat(table.defers(new Configuration(C, C), new Event("f"))).isFalse();
    }
}
