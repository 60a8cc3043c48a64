package org.evoloop.models.temporal;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Queue;
import java.util.Set;
import org.evoloop.check.PairGraph;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Turn;

/**
 * Every moment that can be reached and what can happen next; events that fail lead nowhere.
 *
 * <p>Threading: immutable.
 */
final class MomentGraph {
    private final Moment initial;
    private final Map<Moment, List<Edge>> edges = new LinkedHashMap<>();

    /** A turn and the moment it leads to. */
    record Edge(Turn turn, Moment target) {}

    MomentGraph(PairGraph pairs) {
        initial = new Moment(pairs.initial(), null);
        Queue<Moment> frontier = new ArrayDeque<>(List.of(initial));
        for (Moment moment = frontier.poll(); moment != null; moment = frontier.poll()) {
            if (edges.containsKey(moment)) {
                continue;
            }
            List<Edge> next = new ArrayList<>();
            for (Turn turn : pairs.turnsFrom(moment.at())) {
                if (!(turn.decision() instanceof Decision.Impossible)) {
                    Moment target =
                            new Moment(turn.decision().after(), turn.event().trigger());
                    next.add(new Edge(turn, target));
                    frontier.add(target);
                }
            }
            edges.put(moment, List.copyOf(next));
        }
    }

    Moment initial() {
        return initial;
    }

    /** First reached first. */
    Set<Moment> moments() {
        return edges.keySet();
    }

    List<Edge> from(Moment moment) {
        return edges.getOrDefault(moment, List.of());
    }
}
