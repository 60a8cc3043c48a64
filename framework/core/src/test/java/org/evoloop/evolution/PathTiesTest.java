package org.evoloop.evolution;

import static org.assertj.core.api.Assertions.assertThat;
import static org.evoloop.Machines.machine;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.stream.LongStream;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.StateMachineBuilder;
import org.evoloop.statemachine.Transition;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Which of the cheapest paths is taken, compared with all paths in small random machines. */
class PathTiesTest {
    private static final int STATES = 7;
    private static final List<String> EVENTS = List.of("a", "b", "c", "d");

    static LongStream seeds() {
        return LongStream.concat(LongStream.rangeClosed(1, 300), LongStream.of(new Random().nextLong()));
    }

    private static List<String> way(StateMachine machine, Map<Event, Integer> costs, String from, String to) {
        DeviceEvents device = new DeviceEvents(machine.triggers(), Set.of()).withCosts(costs);
        return new PathPlanner(machine, device)
                .shortestPath(new State(from), List.of(new State(to))).orElseThrow().stream()
                        .map(step -> step.trigger().name())
                        .toList();
    }

    @Test
    void takesTheTransitionDrawnFirstWhereTheWaysPart() {
        StateMachine machine =
                machine("m", "A far -> B", "A near -> C", "C d -> D", "B x -> E", "B d -> D", "E d -> D", "D r -> A");
        assertThat(way(machine, Map.of(), "A", "D")).containsExactly("far", "d");
    }

    @Test
    void takesTheTransitionDrawnFirstThoughTheOtherWayIsFoundSooner() {
        StateMachine machine =
                machine("m", "A dear -> B", "A cheap -> C", "B cheap -> D", "C dear -> D", "D reset -> A");
        assertThat(way(machine, Map.of(new Event("dear"), 5), "A", "D")).containsExactly("dear", "cheap");
    }

    @Test
    void takesFewerEventsBeforeWhatIsDrawnFirst() {
        StateMachine machine = machine("m", "A x -> B", "B y -> D", "A dear -> D", "D r -> A");
        assertThat(way(machine, Map.of(new Event("dear"), 2), "A", "D")).containsExactly("dear");
    }

    @ParameterizedTest
    @MethodSource("seeds")
    void isTheFirstOfAllWaysInTheDocumentedOrder(long seed) {
        Random random = new Random(seed);
        StateMachine machine = drawn(random);
        Map<Event, Integer> costs = new HashMap<>();
        machine.events().forEach(event -> costs.put(event, 1 + random.nextInt(3)));
        PathPlanner planner = new PathPlanner(machine, new DeviceEvents(machine.events(), Set.of()).withCosts(costs));
        State from = machine.initial();

        for (State to : machine.states()) {
            Optional<List<Transition>> found = planner.shortestPath(from, List.of(to))
                    .map(way -> way.stream().map(Step::transition).toList());
            assertThat(found)
                    .as("seed %s, from %s to %s in %s", seed, from, to, machine.transitions())
                    .isEqualTo(ways(machine, from, to).stream().min(order(machine, costs)));
        }
    }

    private static StateMachine drawn(Random random) {
        StateMachineBuilder builder = StateMachine.named("random").initial("S0");
        for (int state = 0; state < STATES; state++) {
            List<String> events = new ArrayList<>(EVENTS);
            for (int many = random.nextInt(1, EVENTS.size()); many > 0; many--) {
                String event = events.remove(random.nextInt(events.size()));
                builder.transition("S" + state, event, "S" + random.nextInt(STATES));
            }
        }
        return builder.build();
    }

    /** Every path that visits no state twice. */
    private static List<List<Transition>> ways(StateMachine machine, State from, State to) {
        List<List<Transition>> found = new ArrayList<>();
        walk(machine, from, to, new ArrayList<>(), new HashSet<>(), found);
        return found;
    }

    private static void walk(
            StateMachine machine,
            State at,
            State to,
            List<Transition> way,
            Set<State> been,
            List<List<Transition>> found) {
        if (at.equals(to)) {
            found.add(List.copyOf(way));
            return;
        }
        been.add(at);
        for (Transition next : machine.transitionsFrom(at)) {
            if (!been.contains(next.target())) {
                way.add(next);
                walk(machine, next.target(), to, way, been, found);
                way.remove(way.size() - 1);
            }
        }
        been.remove(at);
    }

    private static Comparator<List<Transition>> order(StateMachine machine, Map<Event, Integer> costs) {
        return Comparator.<List<Transition>>comparingInt(way ->
                        way.stream().mapToInt(step -> costs.get(step.event())).sum())
                .thenComparingInt(List::size)
                .thenComparing((one, other) -> {
                    int parting = 0;
                    while (parting < one.size() && one.get(parting).equals(other.get(parting))) {
                        parting++;
                    }
                    return parting == one.size()
                            ? 0
                            : drawn(machine, one.get(parting)) - drawn(machine, other.get(parting));
                });
    }

    private static int drawn(StateMachine machine, Transition transition) {
        return machine.transitionsFrom(transition.source()).indexOf(transition);
    }
}
