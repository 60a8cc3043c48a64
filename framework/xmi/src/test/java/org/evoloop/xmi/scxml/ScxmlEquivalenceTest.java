package org.evoloop.xmi.scxml;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.evoloop.statechart.Flattening;
import org.evoloop.statechart.Vertex;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.Transition;
import org.evoloop.xmi.ChartText;
import org.evoloop.xmi.scxml.RandomScxml.Shape;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** The flat machine behaves like the document, for random documents, events and values of guards. */
class ScxmlEquivalenceTest {
    private static final int CHARTS = 400;
    private static final int EVENTS = 40;

    static Stream<Shape> shapes() {
        return Stream.of(
                new Shape(6, 50, 2, 0, 0),
                new Shape(8, 50, 3, 25, 10),
                new Shape(12, 60, 4, 25, 25),
                new Shape(12, 0, 3, 25, 15));
    }

    @ParameterizedTest
    @MethodSource("shapes")
    void shouldRunTheSameActionsInTheSameOrder(Shape shape) {
        Map<String, Integer> refused = new TreeMap<>();
        int compared = 0;
        for (long seed = 1; seed <= CHARTS; seed++) {
            String document = RandomScxml.draw(new Random(seed), shape);
            Flattening flattening =
                    Flattening.of(ChartText.machines(document).get(0).statechart());
            if (flattening.problems().isEmpty()) {
                compare(seed, document, flattening);
                compared++;
            } else {
                flattening.problems().stream()
                        .map(problem -> problem.message().replaceAll("'[^']*'|\\(.*|\\d+|\\[.*?]", ""))
                        .distinct()
                        .forEach(problem -> refused.merge(problem, 1, Integer::sum));
            }
        }
        assertThat(compared).as("%s, refused: %s", shape, refused).isGreaterThan(CHARTS * 8 / 10);
    }

    static void compare(long seed, String document, Flattening flattening) {
        Random random = new Random(-seed);
        ScxmlInterpreter expected = new ScxmlInterpreter(document);
        StateMachine machine = flattening.machine();
        State state = machine.initial();
        List<String> story = new ArrayList<>();
        assertThat(machine.initialEffects())
                .as("seed %d of %s", seed, document)
                .isEqualTo(expected.start(guard -> random.nextBoolean()));
        for (int i = 0; i <= EVENTS; i++) {
            assertThat(flattening.leaves().getOrDefault(state, List.of()).stream()
                            .map(Vertex::key)
                            .toList())
                    .as("seed %d, leaves after %s of %s", seed, story, document)
                    .isEqualTo(expected.leaves());
            Map<String, Boolean> values = Map.of("g", random.nextBoolean(), "h", random.nextBoolean());
            String event = anEvent(machine, state, random);
            story.add(event + values);
            List<String> actions = expected.dispatch(event, guard -> values.getOrDefault(guard, false));
            Transition taken = taken(machine, state, event, values);
            assertThat(taken == null ? List.of() : taken.effects())
                    .as("seed %d, effects after %s of %s", seed, story, document)
                    .isEqualTo(actions == null ? List.of() : actions);
            state = taken == null ? state : taken.target();
        }
    }

    private static String anEvent(StateMachine machine, State state, Random random) {
        List<Transition> enabled = machine.transitionsFrom(state);
        String event = enabled.isEmpty() || random.nextInt(5) == 0
                ? RandomScxml.EVENTS.get(random.nextInt(RandomScxml.EVENTS.size()))
                : enabled.get(random.nextInt(enabled.size())).event().name();
        return machine.events().stream().anyMatch(known -> known.name().equals(event)) ? event : "*";
    }

    private static @Nullable Transition taken(
            StateMachine machine, State state, String event, Map<String, Boolean> values) {
        return machine.transitionsFrom(state).stream()
                .filter(transition -> transition.event().name().equals(event)
                        && transition.event().guards().stream().allMatch(guard -> values.getOrDefault(guard, false)))
                .findFirst()
                .orElse(null);
    }
}
