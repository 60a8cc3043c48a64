package org.evoloop.evolution;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.evoloop.Machines.machine;

import java.util.List;
import java.util.Map;
import java.util.Set;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.junit.jupiter.api.Test;

class PathPlannerTest {
    private final StateMachine robot = machine(
            "robot",
            "On Clean -> Clean / brushes",
            "On Max -> Max",
            "Clean Stop -> Spot",
            "Max Slow -> Slow",
            "Slow Stop -> Spot",
            "Spot Stop -> On");
    private final DeviceEvents device = device(robot);

    private static DeviceEvents device(StateMachine machine) {
        return new DeviceEvents(machine.triggers(), Set.of());
    }

    private static List<String> way(StateMachine machine, DeviceEvents device, String from, String to) {
        return new PathPlanner(machine, device)
                .shortestPath(new State(from), List.of(new State(to))).orElse(List.of()).stream()
                        .map(Step::toString)
                        .toList();
    }

    @Test
    void takesTheFewestEventsIfNothingElseIsSaid() {
        assertThat(way(robot, device, "On", "Spot")).containsExactly("On --Clean--> Clean", "Clean --Stop--> Spot");
    }

    @Test
    void takesTheLongerWayIfItCostsLess() {
        DeviceEvents dear = device.withCosts(Map.of(new Event("Clean"), 5));
        assertThat(way(robot, dear, "On", "Spot"))
                .containsExactly("On --Max--> Max", "Max --Slow--> Slow", "Slow --Stop--> Spot");
        assertThat(way(robot, device.withCosts(Map.of(new Event("Clean"), 2)), "On", "Spot"))
                .as("equal costs: the one drawn first")
                .hasSize(2);
    }

    @Test
    void doesNotPassWhatMustNotBePassedButBeginsAndEndsThere() {
        DeviceEvents careful = device.withDoNotPass(Set.of(new State("Clean")));
        assertThat(way(robot, careful, "On", "Spot"))
                .containsExactly("On --Max--> Max", "Max --Slow--> Slow", "Slow --Stop--> Spot");
        assertThat(way(robot, careful, "On", "Clean")).containsExactly("On --Clean--> Clean");
        assertThat(way(robot, careful, "Clean", "On")).hasSize(2);
    }

    @Test
    void marksWhatTheDeviceDoesByItselfOnTheWay() {
        List<Step> way = new PathPlanner(robot, device)
                .shortestPath(new State("On"), List.of(new State("Spot")))
                .orElseThrow();
        assertThat(way.get(0).effects()).containsExactly("brushes");
        assertThat(way.get(1).effects()).isEmpty();
    }

    @Test
    void usesAGuardedTransitionOnlyIfItsGuardCanBeAskedAndThereIsNoOtherWay() {
        StateMachine lamp =
                machine("lamp", "Off press [dark] -> Bright", "Off dim -> Dim", "Dim up -> Half", "Half up -> Bright");
        assertThat(way(lamp, device(lamp).withBoundGuards(Set.of("dark")), "Off", "Bright"))
                .hasSize(3);

        StateMachine only = machine("only", "Off press [dark] -> Bright", "Off press -> Dim");
        assertThat(way(only, device(only), "Off", "Bright")).isEmpty();
        assertThat(way(only, device(only), "Off", "Dim"))
                .as("without its guard the other branch is no more certain")
                .isEmpty();
        DeviceEvents asking = device(only).withBoundGuards(Set.of("dark"));
        assertThat(way(only, asking, "Off", "Bright")).containsExactly("Off --press [dark]--> Bright");
        assertThat(way(only, asking, "Off", "Dim")).containsExactly("Off --press--> Dim");
    }

    @Test
    void neverUsesATransitionThatAnotherOneShadows() {
        StateMachine shadowed = machine("shadowed", "Off press -> Dim", "Off press [dark] -> Bright");
        assertThat(way(shadowed, device(shadowed).withBoundGuards(Set.of("dark")), "Off", "Bright"))
                .isEmpty();
    }

    @Test
    void continuesASearchThatWasStoppedAtANearerTarget() {
        PathPlanner planner = new PathPlanner(robot, device);
        assertThat(planner.shortestPath(new State("On"), List.of(new State("Clean")))
                        .orElseThrow())
                .hasSize(1);
        assertThat(planner.shortestPath(new State("On"), List.of(new State("Slow")))
                        .orElseThrow())
                .hasSize(2);
        assertThat(planner.shortestPath(new State("On"), List.of(new State("Nowhere"))))
                .isEmpty();
        assertThat(planner.shortestPath(new State("On"), List.of(new State("Max")))
                        .orElseThrow())
                .hasSize(1);
    }

    @Test
    void refusesACostThatIsOutOfRange() {
        assertThatThrownBy(() -> device.withCosts(Map.of(new Event("Clean"), 0)))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("the cost of Clean is 0, allowed is 1 to 1000000");
    }
}
