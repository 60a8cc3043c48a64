package org.evoloop.check.temporal;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Queue;
import java.util.Set;
import org.evoloop.check.PairGraph;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Turn;

/**
 * All reachable moments and their possible successors; events that fail lead nowhere.
 *
 * <p>Threading: immutable.
 *
 * @since 0.1
 */
public final class MomentGraph {
    private final Moment initial;
    private final Map<Moment, List<Edge>> edges = new LinkedHashMap<>();

    /** A turn and the moment to which it leads. */
    public record Edge(Turn turn, Moment target) {}

    /** The graph from the initial states. */
    public MomentGraph(PairGraph pairs) {
        this(pairs, new Moment(pairs.initial(), null));
    }

    /** The graph from {@code initial}, whose states are in {@code pairs}. */
    MomentGraph(PairGraph pairs, Moment initial) {
        this.initial = initial;
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

    /** The first moment. */
    public Moment initial() {
        return initial;
    }

    /** All moments, in the order of exploration. */
    public Set<Moment> moments() {
        return Collections.unmodifiableSet(edges.keySet());
    }

    /** The edges from {@code moment}; empty at an end. */
    public List<Edge> from(Moment moment) {
        return edges.getOrDefault(moment, List.of());
    }
}
