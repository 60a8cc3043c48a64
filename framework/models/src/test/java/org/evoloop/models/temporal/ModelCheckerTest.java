package org.evoloop.models.temporal;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.function.Predicate;
import java.util.function.UnaryOperator;
import java.util.stream.LongStream;
import org.evoloop.check.CheckInput;
import org.evoloop.check.FunctionSends;
import org.evoloop.check.PairGraph;
import org.evoloop.check.temporal.Assurance;
import org.evoloop.check.temporal.Formula;
import org.evoloop.check.temporal.Formula.Atom;
import org.evoloop.check.temporal.Moment;
import org.evoloop.check.temporal.MomentGraph;
import org.evoloop.check.temporal.Outlook;
import org.evoloop.evolution.DecisionTable;
import org.evoloop.evolution.ModelPair;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Random formulas over random machines: M3C, {@link Outlook} and the textbook's fixed points agree on every moment. */
class ModelCheckerTest {
    static LongStream seeds() {
        return LongStream.concat(LongStream.rangeClosed(1, 30), LongStream.of(new Random().nextLong()));
    }

    @ParameterizedTest(name = "seed {0}")
    @MethodSource("seeds")
    void agreesWithTheTextbook(long seed) {
        Random random = new Random(seed);
        ModelPair pair = RandomModels.pair(random);
        DecisionTable table = DecisionTable.compile(pair, CheckInput.of(pair).device());
        MomentGraph graph = new MomentGraph(new PairGraph(pair.initial(), table));
        Outlook outlook = new Outlook(table);
        ModelChecker checker = new ModelChecker(pair, graph);
        for (int number = 0; number < 10; number++) {
            Formula formula = RandomModels.formula(random, 3);
            Set<Moment> satisfying = satisfying(formula, Seen.all(graph), pair);
            for (Moment moment : graph.moments()) {
                assertThat(checker.holds(formula, moment))
                        .as(
                                "%s in %s of %s, seed %d",
                                formula, moment, pair.evolved().transitions(), seed)
                        .isEqualTo(satisfying.contains(moment))
                        .isEqualTo(outlook.holds(formula, moment));
            }
        }
    }

    /** What is sure is so whichever events each function sends, and is everything if none sends any. */
    @ParameterizedTest(name = "seed {0}")
    @MethodSource("seeds")
    void whatIsSureIsSoWhateverFunctionsSend(long seed) {
        Random random = new Random(seed);
        ModelPair pair = RandomModels.pair(random);
        CheckInput input = CheckInput.of(pair);
        for (State state : pair.evolved().states()) {
            for (Event event : pair.isNew(state) ? input.device().sendable() : Set.<Event>of()) {
                input = input.withSends(state.name(), event.name());
            }
        }
        DecisionTable table = DecisionTable.compile(input.pair(), input.device());
        MomentGraph graph = MomentGraph.withSends(table, FunctionSends.possible(input), 1_000)
                .orElseThrow();
        MomentGraph silent = new MomentGraph(new PairGraph(pair.initial(), table));
        Assurance assurance = new Assurance(graph, pair);
        Assurance ofSilent = new Assurance(silent, pair);
        for (int number = 0; number < 20; number++) {
            Formula formula = RandomModels.formula(random, 3);
            String what = formula + " of " + pair.evolved().transitions() + ", seed " + seed;
            for (int functions = 0; functions < 10; functions++) {
                boolean holds =
                        satisfying(formula, Seen.of(graph, random), pair).contains(graph.initial());
                assertThat(assurance.verdict(formula)).as(what).isIn(Optional.empty(), Optional.of(holds));
            }
            boolean holds = satisfying(formula, Seen.all(silent), pair).contains(silent.initial());
            assertThat(ofSilent.verdict(formula)).as(what).contains(holds);
        }
    }

    /** A graph, or what is left of it for certain functions. */
    private record Seen(Map<Moment, List<MomentGraph.Edge>> edges) {
        static Seen all(MomentGraph graph) {
            Map<Moment, List<MomentGraph.Edge>> edges = new LinkedHashMap<>();
            graph.moments().forEach(moment -> edges.put(moment, graph.from(moment)));
            return new Seen(edges);
        }

        /** In each moment, a function sends nothing, or may send some events, or sends one of some at once. */
        static Seen of(MomentGraph graph, Random random) {
            Map<Moment, Double> order = new HashMap<>();
            graph.moments().forEach(moment -> order.put(moment, random.nextDouble()));
            Map<Moment, List<MomentGraph.Edge>> edges = new LinkedHashMap<>();
            for (Moment moment : graph.moments()) {
                // No circle, since a function does not send for ever.
                List<MomentGraph.Edge> left = new ArrayList<>(graph.from(moment));
                left.removeIf(edge ->
                        edge.isSent() && (random.nextBoolean() || order.get(edge.target()) >= order.get(moment)));
                if (left.stream().anyMatch(MomentGraph.Edge::isSent) && random.nextBoolean()) {
                    left.removeIf(edge -> !edge.isSent());
                }
                edges.put(moment, left);
            }
            return new Seen(edges);
        }

        Set<Moment> moments() {
            return edges.keySet();
        }

        List<MomentGraph.Edge> from(Moment moment) {
            return edges.get(moment);
        }
    }

    private static Set<Moment> satisfying(Formula formula, Seen graph, ModelPair pair) {
        List<Set<Moment>> parts = new ArrayList<>();
        formula.operands().forEach(operand -> parts.add(satisfying(operand, graph, pair)));
        if (formula instanceof Atom atom) {
            return only(graph, moment -> moment.shows(atom, pair));
        } else if (formula instanceof Formula.Not) {
            return only(graph, moment -> !parts.get(0).contains(moment));
        } else if (formula instanceof Formula.And) {
            return only(graph, moment -> parts.stream().allMatch(part -> part.contains(moment)));
        } else if (formula instanceof Formula.Or) {
            return only(graph, moment -> parts.stream().anyMatch(part -> part.contains(moment)));
        } else if (formula instanceof Formula.Next) {
            return only(graph, moment -> allNext(graph, moment, parts.get(0)));
        } else if (formula instanceof Formula.Always) {
            return fixedPoint(
                    graph.moments(),
                    known -> only(graph, moment -> parts.get(0).contains(moment) && allNext(graph, moment, known)));
        } else if (formula instanceof Formula.Can) {
            return fixedPoint(
                    Set.of(),
                    known -> only(
                            graph,
                            moment -> parts.get(0).contains(moment)
                                    || graph.from(moment).stream().anyMatch(edge -> known.contains(edge.target()))));
        } else if (formula instanceof Formula.Unless) {
            return fixedPoint(graph.moments(), known -> weakly(graph, parts, known));
        } else if (formula instanceof Formula.Until) {
            return fixedPoint(Set.of(), known -> strongly(graph, parts.get(0), parts.get(1), known));
        } else if (formula instanceof Formula.Eventually) {
            return fixedPoint(Set.of(), known -> strongly(graph, graph.moments(), parts.get(0), known));
        }
        throw new AssertionError(formula);
    }

    private static Set<Moment> weakly(Seen graph, List<Set<Moment>> parts, Set<Moment> known) {
        return only(
                graph,
                moment -> parts.get(1).contains(moment)
                        || (parts.get(0).contains(moment) && allNext(graph, moment, known)));
    }

    /** Strong until: a moment without a successor does not reach {@code right} unless it satisfies it. */
    private static Set<Moment> strongly(Seen graph, Set<Moment> left, Set<Moment> right, Set<Moment> known) {
        return only(
                graph,
                moment -> right.contains(moment)
                        || (left.contains(moment) && !graph.from(moment).isEmpty() && allNext(graph, moment, known)));
    }

    private static boolean allNext(Seen graph, Moment moment, Set<Moment> wanted) {
        return graph.from(moment).stream().allMatch(edge -> wanted.contains(edge.target()));
    }

    private static Set<Moment> only(Seen graph, Predicate<Moment> test) {
        Set<Moment> found = new HashSet<>(graph.moments());
        found.removeIf(test.negate());
        return found;
    }

    private static Set<Moment> fixedPoint(Set<Moment> start, UnaryOperator<Set<Moment>> step) {
        Set<Moment> known = start;
        for (Set<Moment> next = step.apply(known); !next.equals(known); next = step.apply(known)) {
            known = next;
        }
        return known;
    }
}
