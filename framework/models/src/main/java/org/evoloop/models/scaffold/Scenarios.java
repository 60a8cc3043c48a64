package org.evoloop.models.scaffold;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.evoloop.check.PairGraph;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.DecisionTable;
import org.evoloop.evolution.DeviceEvents;
import org.evoloop.evolution.GuardedTriggers;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Step;
import org.evoloop.evolution.Turn;
import org.evoloop.models.scaffold.Scenario.Happening;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.Transition;

/** Finds a scenario for each transition of the new model that a test can take. */
final class Scenarios {
    private final ModelPair pair;
    private final DecisionTable table;
    private final PairGraph graph;
    private final GuardedTriggers originalGuards;
    private final GuardedTriggers evolvedGuards;

    Scenarios(ModelPair pair, DeviceEvents device) {
        this.pair = pair;
        this.table = DecisionTable.compile(pair, device);
        this.graph = new PairGraph(pair.initial(), table);
        this.originalGuards = new GuardedTriggers(pair.original());
        this.evolvedGuards = new GuardedTriggers(pair.evolved());
    }

    /**
     * The shortest scenario of each transition, in the new model's order; transitions that no test can take are
     * missing.
     */
    Map<Transition, Scenario> all() {
        Map<State, List<Configuration>> byState = new LinkedHashMap<>();
        for (Configuration at : graph.configurations()) {
            byState.computeIfAbsent(at.evolved(), state -> new ArrayList<>()).add(at);
        }
        Map<Transition, Scenario> scenarios = new LinkedHashMap<>();
        for (Transition transition : pair.evolved().transitions()) {
            byState.getOrDefault(transition.source(), List.of()).stream()
                    .flatMap(at -> scenario(at, transition).stream())
                    .min(Comparator.comparingInt(found -> found.happenings().size()))
                    .ifPresent(found -> scenarios.put(transition, found));
        }
        return scenarios;
    }

    private Optional<Scenario> scenario(Configuration at, Transition transition) {
        Decision decision = table.decide(at, transition.event(), false);
        List<Turn> turns = Stream.concat(
                        graph.wayTo(at).stream(), Stream.of(new Turn(transition.event(), false, decision)))
                .toList();
        if (!turns.stream().allMatch(this::canHappen)) {
            return Optional.empty();
        }
        return Optional.of(
                new Scenario(transition, turns.stream().map(this::happening).toList(), decision.after()));
    }

    private boolean isDevicesOwn(Event trigger) {
        return table.device().isOwn(trigger);
    }

    /** Whether the event can occur there, and the guards required for it enable no other transition. */
    private boolean canHappen(Turn turn) {
        Configuration before = turn.decision().before();
        Event trigger = turn.event().trigger();
        Set<String> guards = guards(turn);
        if (turn.decision() instanceof Decision.Impossible
                || (isDevicesOwn(trigger) && !pair.original().hasTrigger(before.original(), trigger))) {
            return false;
        }
        Transition taken = turn.decision().transition();
        boolean heard = taken == null
                || taken.event().equals(evolvedGuards.resolve(before.evolved(), trigger, guards::contains));
        return heard
                && turn.decision().steps().stream()
                        .allMatch(step -> step.event()
                                .equals(originalGuards.resolve(step.source(), step.trigger(), guards::contains)));
    }

    private static Set<String> guards(Turn turn) {
        Set<String> guards = new HashSet<>(turn.event().guards());
        for (Step step : turn.decision().steps()) {
            guards.addAll(step.event().guards());
        }
        return guards;
    }

    private Happening happening(Turn turn) {
        Event trigger = turn.event().trigger();
        Duration delay = trigger.timeTrigger()
                .filter(duration ->
                        comesFirst(duration, trigger, turn.decision().before()))
                .orElse(null);
        return new Happening(trigger.name(), guards(turn), isDevicesOwn(trigger), delay);
    }

    /** Whether waiting for {@code duration} raises {@code trigger} before any other time event of either model. */
    private boolean comesFirst(Duration duration, Event trigger, Configuration at) {
        return Stream.concat(timers(pair.evolved(), at.evolved()), timers(pair.original(), at.original()))
                .filter(other -> !other.equals(trigger))
                .noneMatch(other -> other.timeTrigger().orElseThrow().compareTo(duration) <= 0);
    }

    private static Stream<Event> timers(StateMachine machine, State state) {
        return machine.transitionsFrom(state).stream()
                .map(transition -> transition.event().trigger())
                .filter(event -> event.timeTrigger().isPresent());
    }
}
