package org.evoloop.models.temporal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assumptions.assumeThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import java.util.stream.LongStream;
import org.evoloop.check.CheckInput;
import org.evoloop.check.PairGraph;
import org.evoloop.check.temporal.Formula;
import org.evoloop.check.temporal.Moment;
import org.evoloop.check.temporal.MomentGraph;
import org.evoloop.check.temporal.Outlook;
import org.evoloop.check.temporal.Property;
import org.evoloop.check.temporal.PropertyWatch;
import org.evoloop.evolution.DecisionTable;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Turn;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Compares {@link PropertyWatch} on random sequences of events in random evolutions with M3C on the models. */
class WatchAgainstCheckerTest {
    private static final int FORMULAS = 40;
    private static final int EVENTS = 12;

    private DecisionTable table;
    private MomentGraph graph;
    private ModelChecker checker;

    static LongStream seeds() {
        return LongStream.concat(LongStream.rangeClosed(1, 30), LongStream.of(new Random().nextLong()));
    }

    private void evolution(Random random) {
        ModelPair pair = RandomModels.pair(random);
        table = DecisionTable.compile(pair, CheckInput.of(pair).device());
        graph = new MomentGraph(new PairGraph(pair.initial(), table));
        checker = new ModelChecker(pair, graph);
    }

    private List<Moment> walk(Random random) {
        List<Moment> walk = new ArrayList<>(List.of(graph.initial()));
        for (int step = 0; step < EVENTS; step++) {
            List<MomentGraph.Edge> next = graph.from(walk.get(walk.size() - 1));
            if (!next.isEmpty()) {
                walk.add(next.get(random.nextInt(next.size())).target());
            }
        }
        return walk;
    }

    /** The number of events after which it is broken; -1 if it is not. */
    private int brokenAt(Formula formula, List<Moment> walk) {
        Property property = new Property("p", formula, 1);
        PropertyWatch watch =
                new PropertyWatch(List.of(property), table, graph.initial().at());
        for (int step = 1; watch.broken().isEmpty() && step < walk.size(); step++) {
            Moment moment = walk.get(step);
            boolean breaks = watch.happened(moment.at(), moment.last()).contains(property);
            assertThat(breaks).isEqualTo(watch.standing(property) == PropertyWatch.Standing.BROKEN);
            if (breaks) {
                return step;
            }
        }
        return watch.broken().isEmpty() ? -1 : 0;
    }

    @ParameterizedTest(name = "seed {0}")
    @MethodSource("seeds")
    void whatTheWatchSaysIsBrokenDoesNotHold(long seed) {
        Random random = new Random(seed);
        evolution(random);
        Refutation refutation = new Refutation(table.models(), new Outlook(table));
        for (int number = 0; number < FORMULAS; number++) {
            Formula formula = RandomModels.formula(random, 3);
            List<Moment> walk = walk(random);
            int broken = brokenAt(formula, walk);
            int first = IntStream.range(0, walk.size())
                    .filter(last -> refutation.of(formula, walk.subList(0, last + 1)))
                    .findFirst()
                    .orElse(-1);
            assertThat(broken).as("%s along %s, seed %d", formula, walk, seed).isEqualTo(first);
            if (broken >= 0) {
                assertThat(checker.holds(formula, graph.initial()))
                        .as("%s along %s, seed %d", formula, walk, seed)
                        .isFalse();
            }
        }
    }

    @ParameterizedTest(name = "seed {0}")
    @MethodSource("seeds")
    void theCheckersCounterExamplesBreakInTheWatch(long seed) {
        Random random = new Random(seed);
        evolution(random);
        int examples = 0;
        for (int number = 0; number < FORMULAS; number++) {
            Formula formula = RandomModels.safety(random);
            if (!checker.holds(formula, graph.initial())) {
                examples++;
                List<Moment> moments = new ArrayList<>(List.of(graph.initial()));
                for (Turn turn : CounterExample.of(formula, graph, checker)) {
                    moments.add(new Moment(turn.decision().after(), turn.event().trigger()));
                }
                assertThat(brokenAt(formula, moments))
                        .as("%s along %s, seed %d", formula, moments, seed)
                        .isBetween(0, moments.size() - 1);
            }
        }
        assumeThat(examples).as("random formulas that do not hold").isPositive();
    }
}
