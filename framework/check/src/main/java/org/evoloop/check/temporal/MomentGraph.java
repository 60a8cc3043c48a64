package org.evoloop.check.temporal;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Queue;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Stream;
import org.evoloop.check.FunctionSends;
import org.evoloop.check.PairGraph;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.DecisionTable;
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
    public record Edge(Turn turn, Moment target) {
        /** Whether a function sends the event, if it does so at all. */
        public boolean isSent() {
            return turn.decision() instanceof Decision.Sending;
        }
    }

    /** The graph from the initial states, as long as no function sends anything. */
    public MomentGraph(PairGraph pairs) {
        this(pairs, new Moment(pairs.initial(), null));
    }

    /** The graph from {@code initial}, whose states are in {@code pairs}. */
    MomentGraph(PairGraph pairs, Moment initial) {
        this(initial, at -> unsent(pairs.turnsFrom(at)), Integer.MAX_VALUE);
    }

    /**
     * The graph from the initial states, with what functions may send.
     *
     * @param most the number of moments beyond which it is not explored, since each new state may occur with each state
     *     of the device
     * @return empty if there are more
     */
    public static Optional<MomentGraph> withSends(DecisionTable table, FunctionSends sends, int most) {
        MomentGraph graph = new MomentGraph(
                new Moment(table.models().initial(), null),
                at -> Stream.of(unsent(table.expected(at)), table.interference(at), sends.from(at, table))
                        .flatMap(List::stream)
                        .toList(),
                most);
        return Optional.of(graph).filter(explored -> explored.edges.size() <= most);
    }

    /** What no function sends. */
    private static List<Turn> unsent(List<Turn> turns) {
        return turns.stream()
                .filter(turn -> !(turn.decision() instanceof Decision.Sending))
                .toList();
    }

    private MomentGraph(Moment initial, Function<Configuration, List<Turn>> turns, int most) {
        this.initial = initial;
        Queue<Moment> frontier = new ArrayDeque<>();
        for (Moment moment = initial; moment != null && edges.size() <= most; moment = frontier.poll()) {
            if (edges.containsKey(moment)) {
                continue;
            }
            List<Edge> next = new ArrayList<>();
            for (Turn turn : turns.apply(moment.at())) {
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
