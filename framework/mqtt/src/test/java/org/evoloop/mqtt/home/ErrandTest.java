package org.evoloop.mqtt.home;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.evoloop.PaperModels;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.junit.jupiter.api.Test;

class ErrandTest {
    private final StateMachine robot = PaperModels.cleaningRobot().evolved();
    private final List<String> pressed = new ArrayList<>();

    private Errand to(String goal) {
        return new Errand(
                new Way(robot, Set.of("Clean", "Spot"), state -> true, false),
                robot.alike(new State(goal)),
                pressed::add,
                0);
    }

    /** Makes the model follow each press at once, without waiting. */
    private State follow(Errand errand, String from) {
        State now = new State(from);
        int seen = 0;
        while (errand.step(now, 0) && pressed.size() > seen) {
            now = robot.nextState(now, new Event(pressed.get(seen++))).orElseThrow();
        }
        return now;
    }

    @Test
    void everyButtonOnTheWayIsPressed() {
        assertThat(follow(to("Clean"), "Off")).isEqualTo(new State("Clean"));
        assertThat(pressed).containsExactly("Clean", "Clean");
    }

    @Test
    void whoIsThereHasNothingToDo() {
        assertThat(to("On").step(new State("On"), 0)).isFalse();
        assertThat(pressed).isEmpty();
    }

    @Test
    void aTimerIsWaitedForRatherThanADetourTaken() {
        Errand errand = to("Clean");
        assertThat(errand.step(new State("SpotWait"), 0)).isTrue();
        assertThat(pressed).isEmpty();
        assertThat(errand.step(new State("On"), 0)).isTrue();
        assertThat(pressed).containsExactly("Clean");
    }

    @Test
    void aButtonIsPressedOnceInAState() {
        Errand errand = to("Clean");
        errand.step(new State("On"), 0);
        assertThat(errand.step(new State("On"), 0)).isTrue();
        assertThat(pressed).containsExactly("Clean");
        assertThat(errand.step(new State("On"), Errand.LIMIT.toNanos() + 1)).isFalse();
    }

    @Test
    void whatOnlyTheDeviceOrAFunctionCanDoIsRefused() {
        assertThatThrownBy(() -> to("On").step(new State("Spot"), 0))
                .isInstanceOf(IllegalStateException.class)
                .hasMessageContaining("from Spot to On");
        assertThatThrownBy(() -> to("On").step(new State("Move"), 0)).isInstanceOf(IllegalStateException.class);
    }

    @Test
    void itIsOverWhenSomethingElseHappensOnTheWay() {
        Errand errand = to("Clean");
        assertThat(errand.step(new State("Off"), 0)).isTrue();
        assertThat(errand.step(new State("Spot"), 0)).isFalse();
        assertThat(pressed).as("nothing is pressed in Spot").containsExactly("Clean");
    }

    @Test
    void itsWayAvoidsStatesThatMustNotBePassed() {
        Way way = new Way(robot, Set.of("Clean", "Spot"), state -> !state.name().equals("On"), false);
        Errand errand = new Errand(way, List.of(new State("Clean")), pressed::add, 0);
        assertThatThrownBy(() -> errand.step(new State("Off"), 0)).isInstanceOf(IllegalStateException.class);
        assertThat(pressed).isEmpty();
    }
}
