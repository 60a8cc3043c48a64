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
 * Every moment that can be reached and what can happen next; events that fail lead nowhere.
 *
 * <p>Threading: immutable.
 *
 * @since 0.1
 */
public final class MomentGraph {
    private final Moment initial;
    private final Map<Moment, List<Edge>> edges = new LinkedHashMap<>();

    /** A turn and the moment it leads to. */
    public record Edge(Turn turn, Moment target) {}

    /** From where both machines start. */
    public MomentGraph(PairGraph pairs) {
        this(pairs, new Moment(pairs.initial(), null));
    }

    /** From {@code initial} on, of which {@code pairs} knows where it stands. */
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

    /** Where it begins. */
    public Moment initial() {
        return initial;
    }

    /** First reached first. */
    public Set<Moment> moments() {
        return Collections.unmodifiableSet(edges.keySet());
    }

    /** What can happen next; nothing where it ends. */
    public List<Edge> from(Moment moment) {
        return edges.getOrDefault(moment, List.of());
    }
}
