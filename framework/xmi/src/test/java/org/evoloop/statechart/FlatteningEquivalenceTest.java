package org.evoloop.statechart;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import java.util.TreeMap;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.Transition;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The flat machine behaves like the statechart, for random charts, events and values of guards. */
class FlatteningEquivalenceTest {
    private static final int CHARTS = 1_000;
    private static final int EVENTS = 50;
    private static final int REGIONS = 200;

    @Test
    void shouldAcceptTheSameEventsAndRunTheSameActionsInTheSameOrder() {
        Map<String, Integer> refused = new TreeMap<>();
        int compared = 0;
        int waiting = 0;
        for (long seed = 1; compared < CHARTS; seed++) {
            Statechart chart = RandomChart.draw(new Random(seed), 4 + (int) (seed % 8));
            Flattening flattening = Flattening.of(chart);
            if (flattening.problems().isEmpty()) {
                waiting += compare(seed, chart, flattening);
                compared++;
            } else {
                flattening.problems().forEach(problem -> refused.merge(kind(problem), 1, Integer::sum));
                assertThat(seed).as("most charts are refused: %s", refused).isLessThan(30 * CHARTS);
            }
        }
        assertThat(waiting).as("events that are deferred").isGreaterThan(CHARTS / 2);
    }

    @ParameterizedTest
    @CsvSource({"20, 30, 70", "20, 100, 50", "40, 30, 35", "30, 100, 25"})
    void shouldReadMostChartsWithRegionsUnlessTheyAreFullOfConflicts(int transitions, int far, int percent) {
        Map<String, Integer> refused = new TreeMap<>();
        int read = 0;
        for (long seed = 1; seed <= REGIONS; seed++) {
            Statechart chart = RandomRegions.draw(new Random(seed), new RandomRegions.Shape(transitions, far));
            Flattening flattening = Flattening.of(chart);
            if (flattening.problems().isEmpty()) {
                compare(seed, chart, flattening);
                read++;
            } else {
                flattening.problems().stream()
                        .map(FlatteningEquivalenceTest::kind)
                        .distinct()
                        .forEach(problem -> refused.merge(problem, 1, Integer::sum));
            }
        }
        assertThat(read).as("refused: %s", refused).isGreaterThan(REGIONS * percent / 100);
        assertThat(refused.keySet()).allMatch(problem -> problem.startsWith("one event triggers two transitions"));
    }

    private static String kind(Problem problem) {
        return problem.message().replaceAll("'[^']*'|\\(.*|\\d+", "");
    }

    /** Compares the two; returns how many events were deferred. */
    private static int compare(long seed, Statechart chart, Flattening flattening) {
        Random random = new Random(-seed);
        Interpreter expected = new Interpreter(chart);
        FlatRun actual = new FlatRun(flattening);
        List<String> story = new ArrayList<>();
        int waiting = 0;
        String what = "seed " + seed + " of " + flattening.machine();
        assertThat(actual.machine.initialEffects()).as(what).isEqualTo(expected.start(guard -> random.nextBoolean()));
        actual.check(expected, what, story);
        for (int i = 0; i < EVENTS; i++) {
            Map<String, Boolean> values = Map.of("g", random.nextBoolean(), "h", random.nextBoolean());
            String event = anEvent(actual, random);
            story.add(event + values);
            List<String> actions = expected.dispatch(Drawing.drawn(event), guard -> values.getOrDefault(guard, false));
            actual.dispatch(event, values, actions, expected.waits(), what + ", events " + story);
            actual.check(expected, what, story);
            waiting += expected.waits() ? 1 : 0;
        }
        return waiting;
    }

    /** A random event, mostly one that can have an effect. */
    private static String anEvent(FlatRun run, Random random) {
        List<Transition> enabled = run.machine.transitionsFrom(run.state);
        if (enabled.isEmpty() || random.nextInt(5) == 0) {
            return RandomChart.EVENTS.get(random.nextInt(3));
        }
        return enabled.get(random.nextInt(enabled.size())).event().name();
    }

    /** Runs a machine by the semantics of {@link org.evoloop.statemachine}. */
    private static final class FlatRun {
        private final Flattening flattening;
        private final StateMachine machine;
        private State state;
        private int now = 1;
        private Map<String, Integer> timers = new HashMap<>();

        FlatRun(Flattening flattening) {
            this.flattening = flattening;
            this.machine = flattening.machine();
            this.state = machine.initial();
            startTimers(Set.of());
        }

        void dispatch(
                String event,
                Map<String, Boolean> values,
                @Nullable List<String> expected,
                boolean waits,
                String what) {
            now++;
            Event resolved = resolve(event, values);
            assertThat(machine.defers(state, resolved)).as(what + ": deferred").isEqualTo(waits);
            for (Transition transition : machine.transitionsFrom(state)) {
                if (transition.event().name().equals(event)
                        && transition.event().guards().stream().allMatch(guard -> values.getOrDefault(guard, false))) {
                    List<String> actions = expected == null ? List.of() : expected;
                    assertThat(transition.effects()).as(what).isEqualTo(actions);
                    if (expected == null) {
                        assertThat(transition.internal()).as(what).isTrue();
                    }
                    if (!transition.internal()) {
                        state = transition.target();
                        startTimers(transition.keeps());
                    }
                    return;
                }
            }
            assertThat(expected).as(what + ": nothing is accepted in " + state).isNull();
        }

        /** The event with the guards of the first transition that applies. */
        private Event resolve(String event, Map<String, Boolean> values) {
            return machine.transitionsFrom(state).stream()
                    .map(Transition::event)
                    .filter(known -> known.name().equals(event)
                            && known.guards().stream().allMatch(guard -> values.getOrDefault(guard, false)))
                    .findFirst()
                    .orElse(new Event(event));
        }

        private void startTimers(Set<String> keeps) {
            Map<String, Integer> next = new HashMap<>();
            for (Transition transition : machine.transitionsFrom(state)) {
                String name = transition.event().name();
                if (transition.event().timeTrigger().isPresent()) {
                    next.put(name, keeps.contains(name) ? timers.getOrDefault(name, -1) : now);
                }
            }
            timers = next;
        }

        void check(Interpreter expected, String what, List<String> story) {
            assertThat(flattening.leaves().getOrDefault(state, List.of()).stream()
                            .map(Vertex::key)
                            .toList())
                    .as("%s, leaves after %s", what, story)
                    .isEqualTo(expected.leaves());
            assertThat(timers.entrySet().stream()
                            .map(timer -> timer.getKey().replaceAll(" in .*", "") + " since " + timer.getValue())
                            .sorted()
                            .toList())
                    .as("%s, timers after %s", what, story)
                    .isEqualTo(expected.timers());
            assertThat(machine.activities(state).stream().sorted().toList())
                    .as("%s, activities after %s", what, story)
                    .isEqualTo(expected.activities());
        }
    }
}
