package org.evoloop.migration;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.DecisionTable;
import org.evoloop.evolution.Timers;
import org.evoloop.evolution.Turn;
import org.evoloop.statemachine.Event;

/**
 * The plan of a swap: the fate of every pair of states that the running models can reach. The next models' decision
 * table says which pairs are reachable there, and what has to be sent to get to them.
 *
 * <p>Threading: immutable.
 *
 * @param lines one for each pair of states, in the order of exploration
 * @since 0.1
 */
public record Migration(List<Line> lines) {
    public Migration {
        lines = List.copyOf(lines);
    }

    /** The fate of one pair of states. */
    public record Line(Configuration at, Fate fate) {}

    /** Whether no pair of states is stuck. */
    public boolean isPossible() {
        return lines.stream().noneMatch(line -> line.fate() instanceof Fate.Stuck);
    }

    /** The plan of a swap from the models of {@code running} to those of {@code next}, with the drawn timers. */
    public static Migration plan(DecisionTable running, DecisionTable next, Mapping mapping) {
        Timers drawn = Timers.drawnIn(running.models().evolved());
        Timers nextDrawn = Timers.drawnIn(next.models().evolved());
        return plan(running, new Succession(running, drawn, next, nextDrawn, mapping));
    }

    /** The plan of a swap from the models of {@code running}, by {@code succession}. */
    public static Migration plan(DecisionTable running, Succession succession) {
        return plan(running, succession, Set.of());
    }

    /**
     * The same, also for the pairs of states that the running models reach from these: those in which they took over
     * from others, which may be none that they reach from their initial pair.
     */
    public static Migration plan(DecisionTable running, Succession succession, Set<Configuration> tookOverIn) {
        Map<Configuration, Fate> fates = new LinkedHashMap<>();
        reached(running, tookOverIn).forEach(at -> fates.put(at, succession.fate(at)));
        Map<Configuration, Integer> distances = distances(running, fates);
        List<Line> lines = new ArrayList<>();
        fates.forEach((at, fate) -> lines.add(new Line(at, wait(running, at, fate, distances))));
        return new Migration(lines);
    }

    private static Set<Configuration> reached(DecisionTable running, Set<Configuration> from) {
        Set<Configuration> reached = new LinkedHashSet<>(running.configurations());
        Deque<Configuration> next = new ArrayDeque<>();
        from.stream().filter(reached::add).forEach(next::add);
        while (!next.isEmpty()) {
            turns(running, next.remove()).stream()
                    .map(turn -> turn.decision().after())
                    .filter(reached::add)
                    .forEach(next::add);
        }
        return reached;
    }

    /**
     * The fate of a pair of states in the plan.
     *
     * @throws IllegalArgumentException if the plan does not have it
     */
    public Fate at(Configuration pair) {
        return lines.stream()
                .filter(line -> line.at().equals(pair))
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException("the plan has no pair of states " + pair))
                .fate();
    }

    /** The pairs of states of the next models in which these can take over. */
    public Set<Configuration> ends() {
        return lines.stream()
                .map(Line::fate)
                .filter(Fate.Maps.class::isInstance)
                .map(fate -> ((Fate.Maps) fate).to())
                .collect(Collectors.toCollection(LinkedHashSet::new));
    }

    /**
     * The number of events from each pair of states to the nearest one in which a swap is possible; without pairs that
     * have none.
     */
    private static Map<Configuration, Integer> distances(DecisionTable running, Map<Configuration, Fate> fates) {
        Map<Configuration, Set<Configuration>> comingFrom = new HashMap<>();
        Map<Configuration, Integer> distances = new HashMap<>();
        Deque<Configuration> next = new ArrayDeque<>();
        fates.forEach((at, fate) -> {
            turns(running, at)
                    .forEach(turn -> comingFrom
                            .computeIfAbsent(turn.decision().after(), key -> new LinkedHashSet<>())
                            .add(at));
            if (fate instanceof Fate.Maps) {
                distances.put(at, 0);
                next.add(at);
            }
        });
        while (!next.isEmpty()) {
            Configuration reached = next.remove();
            int further = distances.getOrDefault(reached, 0) + 1;
            for (Configuration from : comingFrom.getOrDefault(reached, Set.of())) {
                if (distances.putIfAbsent(from, further) == null) {
                    next.add(from);
                }
            }
        }
        return distances;
    }

    /** The turns in {@code at} that lead to another pair of states. */
    private static List<Turn> turns(DecisionTable running, Configuration at) {
        List<Turn> turns = new ArrayList<>(running.expected(at));
        turns.addAll(running.interference(at));
        turns.removeIf(turn -> turn.decision() instanceof Decision.Impossible
                || turn.decision().after().equals(at));
        return turns;
    }

    private static Fate wait(
            DecisionTable running, Configuration at, Fate fate, Map<Configuration, Integer> distances) {
        Integer distance = distances.get(at);
        if (!(fate instanceof Fate.Stuck stuck) || distance == null) {
            return fate;
        }
        Set<Event> exits = new LinkedHashSet<>();
        for (Turn turn : turns(running, at)) {
            Integer left = distances.get(turn.decision().after());
            if (left != null && left < distance) {
                exits.add(turn.event());
            }
        }
        List<Event> uncertain = exits.stream()
                .filter(exit -> exit.timeTrigger().isEmpty() || !exit.guards().isEmpty())
                .toList();
        return new Fate.Waits(stuck.because(), List.copyOf(exits), uncertain);
    }
}
