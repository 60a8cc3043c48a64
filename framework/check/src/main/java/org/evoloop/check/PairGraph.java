package org.evoloop.check;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Queue;
import java.util.Set;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.DecisionTable;
import org.evoloop.evolution.Turn;

/**
 * Every configuration that is reachable without a failure, its possible turns, and the shortest way to it.
 *
 * <p>Threading: immutable.
 *
 * @since 0.1
 */
public final class PairGraph {
    private final Configuration initial;
    private final Map<Configuration, List<Turn>> turns = new LinkedHashMap<>();
    private final Map<Configuration, Turn> arrivals = new HashMap<>();

    /** @param initial the configuration from which {@code table} was explored */
    public PairGraph(Configuration initial, DecisionTable table) {
        this.initial = initial;
        Queue<Configuration> frontier = new ArrayDeque<>(List.of(initial));
        explore(frontier, table, false);
        for (Map.Entry<Configuration, List<Turn>> entry : List.copyOf(turns.entrySet())) {
            entry.getValue().addAll(arrive(table.interference(entry.getKey()), frontier));
        }
        explore(frontier, table, true);
    }

    private void explore(Queue<Configuration> frontier, DecisionTable table, boolean withInterference) {
        for (Configuration at = frontier.poll(); at != null; at = frontier.poll()) {
            if (!turns.containsKey(at)) {
                List<Turn> here = new ArrayList<>(arrive(table.expected(at), frontier));
                if (withInterference) {
                    here.addAll(arrive(table.interference(at), frontier));
                }
                turns.put(at, here);
            }
        }
    }

    private List<Turn> arrive(List<Turn> taken, Queue<Configuration> frontier) {
        for (Turn turn : taken) {
            Configuration after = turn.decision().after();
            boolean fails = turn.decision() instanceof Decision.Impossible;
            if (!fails && !after.equals(initial) && arrivals.putIfAbsent(after, turn) == null) {
                frontier.add(after);
            }
        }
        return taken;
    }

    /** The initial states of both machines. */
    public Configuration initial() {
        return initial;
    }

    /** Every configuration, in the order of exploration. */
    public Set<Configuration> configurations() {
        return Collections.unmodifiableSet(turns.keySet());
    }

    /** The possible turns in {@code at}: first the expected ones, then what the device may do by itself instead. */
    public List<Turn> turnsFrom(Configuration at) {
        return Collections.unmodifiableList(turns.getOrDefault(at, List.of()));
    }

    /**
     * The fewest turns that lead to {@code target}; empty for the initial configuration, and for one that is not
     * reachable.
     */
    public List<Turn> wayTo(Configuration target) {
        ArrayDeque<Turn> way = new ArrayDeque<>();
        for (Turn last = arrivals.get(target); last != null; ) {
            way.addFirst(last);
            last = arrivals.get(last.decision().before());
        }
        return List.copyOf(way);
    }

    /** The fewest turns that end with {@code last}. */
    public List<Turn> wayOver(Turn last) {
        List<Turn> way = new ArrayList<>(wayTo(last.decision().before()));
        way.add(last);
        return way;
    }
}
