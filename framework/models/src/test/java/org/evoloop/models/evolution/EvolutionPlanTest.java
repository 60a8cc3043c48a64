package org.evoloop.models.evolution;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Set;
import org.evoloop.evolution.DeviceEvents;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Passage;
import org.evoloop.models.evolution.EvolutionPlan.Kind;
import org.evoloop.models.evolution.EvolutionPlan.Line;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.StateMachineBuilder;
import org.evoloop.statemachine.Transition;
import org.junit.jupiter.api.Test;

class EvolutionPlanTest {
    private static final Event BOOST = new Event("boost");

    /** Two ways from Idle to Fast: a short one through Heating, where the device beeps and hums, and a long one. */
    private static StateMachineBuilder device(String name) {
        return StateMachine.named(name)
                .initial("Idle")
                .transition(
                        new Transition(
                                new State("Idle"), new Event("heat"), new State("Heating"), List.of("beep"), false),
                        "")
                .activities("Heating", List.of("hum"))
                .transition("Heating", "go", "Fast")
                .transition("Idle", "creep", "Slow")
                .transition("Slow", "walk", "Quick")
                .transition("Quick", "go", "Fast");
    }

    private static final ModelPair PAIR = new ModelPair(
            device("device").build(),
            device("system").transition("Idle", "boost", "Fast").build());
    private static final DeviceEvents ALL = new DeviceEvents(PAIR.original().triggers(), Set.of());

    private static Line boost(DeviceEvents device) {
        return EvolutionPlan.of(PAIR, device).lines().stream()
                .filter(line -> line.transition().event().equals(BOOST))
                .findFirst()
                .orElseThrow();
    }

    @Test
    void aPathThroughAStateThatDoesSomethingIsMarkedWithWhatItDoes() {
        Line line = boost(ALL);

        assertThat(line.kind()).isEqualTo(Kind.PATH);
        assertThat(line.passed()).containsExactly(new Passage(new State("Heating"), List.of("hum", "beep")));
        assertThat(line.isMarked()).isTrue();
        assertThat(PlanText.write(EvolutionPlan.of(PAIR, ALL)))
                .contains(
                        "path heat, go (Idle --heat--> Heating --go--> Fast)  ! ON THE WAY: in Heating the device does"
                                + " hum; beep\n");
    }

    @Test
    void aPathAvoidsWhatMustNotBePassedAndWhatCostsMore() {
        for (DeviceEvents other :
                List.of(ALL.withDoNotPass(Set.of(new State("Heating"))), ALL.withCosts(Map.of(new Event("heat"), 5)))) {
            Line line = boost(other);

            assertThat(line.sent()).extracting(step -> step.trigger().name()).containsExactly("creep", "walk", "go");
            assertThat(line.isMarked()).isFalse();
        }
    }

    @Test
    void whatCannotBeCarriedOutHasAReason() {
        Line line = boost(new DeviceEvents(Set.of(new Event("heat"), new Event("creep")), Set.of()));

        assertThat(line.kind()).isEqualTo(Kind.IMPOSSIBLE);
        assertThat(line.reason()).contains("Fast", "Idle", "creep, heat");
    }

    @Test
    void transitionsThatAreNeverTakenAreNamed() {
        ModelPair pair = new ModelPair(
                PAIR.original(),
                device("system").transition("Lost", "boost", "Idle").build());

        assertThat(EvolutionPlan.of(pair, ALL).unreached())
                .extracting(Transition::toString)
                .containsExactly("Lost --boost--> Idle");
    }
}
