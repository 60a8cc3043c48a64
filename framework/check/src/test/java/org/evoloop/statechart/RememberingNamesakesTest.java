package org.evoloop.statechart;

import static org.assertj.core.api.Assertions.assertThat;
import static org.evoloop.statechart.Draw.arc;
import static org.evoloop.statechart.Draw.chart;
import static org.evoloop.statechart.Draw.initial;
import static org.evoloop.statechart.Draw.named;
import static org.evoloop.statechart.Draw.pseudo;
import static org.evoloop.statechart.Draw.region;
import static org.evoloop.statechart.Draw.state;

import org.evoloop.check.Check;
import org.evoloop.check.CheckInput;
import org.evoloop.check.Finding;
import org.evoloop.check.Rule;
import org.evoloop.evolution.ModelPair;
import org.evoloop.statechart.Vertex.ChartState;
import org.evoloop.statechart.Vertex.Kind;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.junit.jupiter.api.Test;

/**
 * The device's states are found by their position, although the new model has history states and reuses their names.
 */
class RememberingNamesakesTest {
    private static final State OUT = new State("Out");

    /** Off and On in C, with Out beside it. */
    private static ChartState power(String entry, Kind kind) {
        return state(
                "Power",
                region(
                        initial("h"),
                        state("C", region(initial("j"), state("Off"), state("On"), pseudo(entry, kind))),
                        state("Out")));
    }

    private static StateMachine device() {
        return Flattening.flatten(chart(
                region(initial("i"), power("x", Kind.JUNCTION)),
                arc("i Power"),
                arc("h C"),
                arc("j Off"),
                arc("Off On p"),
                arc("On Off p"),
                arc("C Out z"),
                arc("Out x h"),
                arc("x Off")));
    }

    /** A model that returns to the state where it was, and has a second Out. */
    private static StateMachine remembering() {
        return Flattening.flatten(chart(
                region(
                        initial("i"),
                        power("H", Kind.SHALLOW_HISTORY),
                        state("Extra", region(initial("k"), named("Other", "Out")))),
                arc("i Power"),
                arc("h C"),
                arc("j Off"),
                arc("k Other"),
                arc("Off On p"),
                arc("On Off p"),
                arc("C Out z"),
                arc("Out H h"),
                arc("Off Extra extra"),
                arc("Extra Off h")));
    }

    @Test
    void shouldFindTheDevicesStateForEveryRememberedState() {
        assertThat(remembering().states()).extracting(State::name).contains("Extra.Out", "Power.Out [history On]");

        ModelPair pair = new ModelPair(device(), remembering());

        assertThat(pair.violations()).isEmpty();
        assertThat(pair.evolvedStates(OUT))
                .extracting(State::name)
                .containsExactly("Out [history Off]", "Out [history On]");
        assertThat(pair.evolvedStates(OUT)).allSatisfy(state -> {
            assertThat(pair.deviceStates(state)).containsExactly(OUT);
            assertThat(pair.evolved().withoutMemory(state)).isEqualTo(OUT);
            assertThat(pair.evolved().paths(state)).containsExactly("Power.Out");
        });
        assertThat(pair.isNew(new State("Extra.Out"))).isTrue();
    }

    @Test
    void shouldLoseNothingInAPairThatRemembers() {
        assertThat(Check.run(CheckInput.of(new ModelPair(device(), remembering()))))
                .extracting(Finding::rule)
                .containsOnly(Rule.SWALLOWED_EVENT, Rule.PASSED_EFFECT);
    }
}
