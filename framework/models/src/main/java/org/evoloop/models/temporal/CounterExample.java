package org.evoloop.models.temporal;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Queue;
import java.util.Set;
import java.util.function.Predicate;
import org.evoloop.check.temporal.Formula;
import org.evoloop.check.temporal.Moment;
import org.evoloop.check.temporal.MomentGraph;
import org.evoloop.check.temporal.MomentGraph.Edge;
import org.evoloop.evolution.Turn;

/**
 * Finds a sequence of events that shows why a formula does not hold, as far as one sequence can: it ends where an
 * {@code always} is violated, or where a required moment can no longer occur, after at most one loop.
 *
 * <p>{@link ModelChecker M3C} decides which moments satisfy a formula.
 */
final class CounterExample {
    private final MomentGraph graph;
    private final ModelChecker checker;
    private final List<Turn> turns = new ArrayList<>();
    private Moment end;

    private CounterExample(MomentGraph graph, ModelChecker checker, Moment start) {
        this.graph = graph;
        this.checker = checker;
        this.end = start;
    }

    /** The events from the initial moment that show that {@code formula} does not hold there. */
    static List<Turn> of(Formula formula, MomentGraph graph, ModelChecker checker) {
        CounterExample example = new CounterExample(graph, checker, graph.initial());
        example.refute(formula);
        return List.copyOf(example.turns);
    }

    /** Extends the example until it shows that {@code formula} does not hold at its current end. */
    private void refute(Formula formula) {
        if (formula instanceof Formula.And and) {
            refute(fails(and.left()).test(end) ? and.left() : and.right());
        } else if (formula instanceof Formula.Or or) {
            refute(or.left() instanceof Formula.Not ? or.right() : or.left());
        } else if (formula instanceof Formula.Not not && not.operand() instanceof Formula.Can can) {
            walk(moment -> true, holds(can.operand()));
        } else if (formula instanceof Formula.Always always) {
            walk(moment -> true, fails(always.operand()));
            refute(always.operand());
        } else if (formula instanceof Formula.Next next) {
            step(fails(next.operand()));
            refute(next.operand());
        } else if (formula instanceof Formula.Eventually eventually) {
            stay(fails(eventually), fails(eventually.operand()));
        } else if (formula instanceof Formula.Unless unless) {
            breakOff(unless.left(), unless.right());
        } else if (formula instanceof Formula.Until until && !breakOff(until.left(), until.right())) {
            stay(fails(until), fails(until.right()));
        }
    }

    /**
     * Extends the example to the nearest moment in which neither holds, through moments in which only {@code left}
     * holds. Returns false if there is none.
     */
    private boolean breakOff(Formula left, Formula right) {
        Predicate<Moment> both = fails(left).and(fails(right));
        boolean found = walk(holds(left).and(fails(right)), both);
        if (found) {
            refute(left);
        }
        return found;
    }

    private Predicate<Moment> holds(Formula formula) {
        return moment -> checker.holds(formula, moment);
    }

    private Predicate<Moment> fails(Formula formula) {
        return holds(formula).negate();
    }

    private void take(Edge edge) {
        turns.add(edge.turn());
        end = edge.target();
    }

    private boolean step(Predicate<Moment> to) {
        Optional<Edge> next =
                graph.from(end).stream().filter(edge -> to.test(edge.target())).findFirst();
        next.ifPresent(this::take);
        return next.isPresent();
    }

    /**
     * Extends the example by the shortest path to a {@code wanted} moment through {@code passable} ones. Returns false
     * if there is none.
     */
    private boolean walk(Predicate<Moment> passable, Predicate<Moment> wanted) {
        Map<Moment, List<Edge>> ways = new HashMap<>(Map.of(end, List.of()));
        Queue<Moment> frontier = new ArrayDeque<>(List.of(end));
        for (Moment at = frontier.poll(); at != null; at = frontier.poll()) {
            List<Edge> way = ways.getOrDefault(at, List.of());
            if (wanted.test(at)) {
                way.forEach(this::take);
                return true;
            }
            if (passable.test(at)) {
                for (Edge edge : graph.from(at)) {
                    List<Edge> longer = new ArrayList<>(way);
                    longer.add(edge);
                    if (ways.putIfAbsent(edge.target(), longer) == null) {
                        frontier.add(edge.target());
                    }
                }
            }
        }
        return false;
    }

    /** Extends the example through moments that satisfy both, until it loops or ends. */
    private void stay(Predicate<Moment> never, Predicate<Moment> without) {
        Set<Moment> seen = new HashSet<>();
        boolean continues = true;
        while (continues && seen.add(end)) {
            continues = step(never.and(without));
        }
    }
}
