package org.evoloop.check.temporal;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Predicate;
import org.evoloop.evolution.ModelPair;

/**
 * The moments of a graph in which a formula holds: the labelling of Clarke, Emerson and Sistla (1986), backwards from
 * the moments where a formula holds to all that lead there. A moment without successors reaches nothing further.
 *
 * <p>Threading: not thread-safe; it caches its results.
 */
final class Labels {
    private final MomentGraph graph;
    private final ModelPair pair;
    private final Map<Moment, List<Moment>> before = new HashMap<>();
    private final Map<Formula, Set<Moment>> answers = new HashMap<>();

    Labels(MomentGraph graph, ModelPair pair) {
        this.graph = graph;
        this.pair = pair;
        for (Moment moment : graph.moments()) {
            for (MomentGraph.Edge edge : graph.from(moment)) {
                before.computeIfAbsent(edge.target(), target -> new ArrayList<>())
                        .add(moment);
            }
        }
    }

    MomentGraph graph() {
        return graph;
    }

    Set<Moment> where(Formula formula) {
        Set<Moment> known = answers.get(formula);
        if (known == null) {
            known = find(formula);
            answers.put(formula, known);
        }
        return known;
    }

    private Set<Moment> find(Formula formula) {
        if (formula.isPlain()) {
            return only(moment -> formula.isSeenIn(moment, pair));
        } else if (formula instanceof Formula.Not not) {
            return others(where(not.operand()));
        } else if (formula instanceof Formula.And and) {
            return only(moment ->
                    where(and.left()).contains(moment) && where(and.right()).contains(moment));
        } else if (formula instanceof Formula.Or or) {
            return only(moment ->
                    where(or.left()).contains(moment) || where(or.right()).contains(moment));
        } else if (formula instanceof Formula.Next next) {
            Set<Moment> wanted = where(next.operand());
            return only(moment -> graph.from(moment).stream().allMatch(edge -> wanted.contains(edge.target())));
        } else if (formula instanceof Formula.Can can) {
            return comingTo(where(can.operand()), graph.moments(), false);
        } else if (formula instanceof Formula.Always always) {
            return others(comingTo(others(where(always.operand())), graph.moments(), false));
        } else if (formula instanceof Formula.Eventually eventually) {
            return comingTo(where(eventually.operand()), graph.moments(), true);
        } else if (formula instanceof Formula.Until until) {
            return comingTo(where(until.right()), where(until.left()), true);
        } else if (formula instanceof Formula.Unless unless) {
            Set<Moment> left = where(unless.left());
            Set<Moment> waiting = others(where(unless.right()));
            return others(comingTo(only(moment -> waiting.contains(moment) && !left.contains(moment)), waiting, false));
        }
        throw new AssertionError(formula);
    }

    /**
     * The moments in {@code goal}, or from which it is reached through {@code passable} moments.
     *
     * @param surely true for whatever happens, false for if the right events come
     */
    private Set<Moment> comingTo(Set<Moment> goal, Set<Moment> passable, boolean surely) {
        Set<Moment> found = new HashSet<>(goal);
        Deque<Moment> frontier = new ArrayDeque<>(goal);
        Map<Moment, Integer> elsewhere = new HashMap<>();
        for (Moment at = frontier.poll(); at != null; at = frontier.poll()) {
            for (Moment earlier : before.getOrDefault(at, List.of())) {
                int left = elsewhere.getOrDefault(earlier, graph.from(earlier).size()) - 1;
                elsewhere.put(earlier, left);
                if (passable.contains(earlier) && (!surely || left == 0) && found.add(earlier)) {
                    frontier.add(earlier);
                }
            }
        }
        return found;
    }

    private Set<Moment> others(Set<Moment> moments) {
        return only(moment -> !moments.contains(moment));
    }

    private Set<Moment> only(Predicate<Moment> test) {
        Set<Moment> found = new HashSet<>(graph.moments());
        found.removeIf(test.negate());
        return found;
    }
}
