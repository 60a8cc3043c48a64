package org.evoloop.models.temporal;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.evoloop.check.CheckInput;
import org.evoloop.check.Element;
import org.evoloop.check.Finding;
import org.evoloop.check.FunctionSends;
import org.evoloop.check.PairGraph;
import org.evoloop.check.Rule;
import org.evoloop.check.properties.PropertyFile;
import org.evoloop.check.temporal.Assurance;
import org.evoloop.check.temporal.Formula;
import org.evoloop.check.temporal.MomentGraph;
import org.evoloop.check.temporal.Property;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.DecisionTable;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Turn;
import org.evoloop.statemachine.State;

/**
 * Checks the properties written beside the models.
 *
 * <p>Threading: one thread.
 */
public final class PropertyCheck {
    /** The number of moments beyond which it is not explored what functions may send. */
    private static final int MOST_MOMENTS = 50_000;

    private final ModelPair pair;
    private final PropertyFile file;
    private final DecisionTable table;
    private final PairGraph pairs;
    private final FunctionSends sends;

    /** As long as no function sends anything. */
    private final MomentGraph graph;

    private final ModelChecker checker;

    /** By the states whose functions may send; empty if there is too much to explore. */
    private final Map<Set<State>, Optional<Assurance>> assurances = new HashMap<>();

    private PropertyCheck(CheckInput input, PropertyFile file) {
        this.pair = input.pair();
        this.file = file;
        this.table = DecisionTable.compile(pair, input.device());
        this.pairs = new PairGraph(pair.initial(), table);
        this.sends = FunctionSends.possible(input);
        this.graph = new MomentGraph(pairs);
        this.checker = new ModelChecker(pair, graph);
    }

    /**
     * Returns a finding for each property that does not hold, with the events that show it, and for each that depends
     * on what functions send.
     *
     * @throws org.evoloop.statemachine.ModelException if the pair is not an evolution
     */
    public static List<Finding> run(CheckInput input, PropertyFile file) {
        input.pair().requireValid();
        PropertyCheck check = new PropertyCheck(input, file);
        return file.properties().stream()
                .flatMap(property -> check.finding(property).stream())
                .toList();
    }

    private Optional<Finding> finding(Property property) {
        Optional<Boolean> verdict = verdict(property.formula(), sends);
        return verdict.isEmpty()
                ? Optional.of(unknown(property))
                : verdict.filter(holds -> !holds).map(fails -> broken(property));
    }

    /** Whether a formula holds, whatever these functions send; empty if that depends on it, or cannot be explored. */
    private Optional<Boolean> verdict(Formula formula, FunctionSends possible) {
        return possible.isEmpty()
                ? Optional.of(holdsIfNothingIsSent(formula))
                : assurance(possible).flatMap(assurance -> assurance.verdict(formula));
    }

    private boolean holdsIfNothingIsSent(Formula formula) {
        return checker.holds(formula, graph.initial());
    }

    private Optional<Assurance> assurance(FunctionSends possible) {
        return assurances.computeIfAbsent(
                possible.states(),
                states -> MomentGraph.withSends(table, possible, MOST_MOMENTS)
                        .map(explored -> new Assurance(explored, pair)));
    }

    private Finding broken(Property property) {
        List<Turn> example = CounterExample.of(property.formula(), graph, checker);
        Configuration end = example.isEmpty()
                ? pair.initial()
                : example.get(example.size() - 1).decision().after();
        return new Finding(
                Rule.PROPERTY,
                new Element.OfState(Element.ModelRole.NEW, end.evolved()),
                named(property) + " does not hold",
                "change the new model, or the property if it asks for too much",
                example);
    }

    private Finding unknown(Property property) {
        boolean isExplored = assurance(sends).isPresent();
        List<State> alone = sends.states().stream()
                .filter(state -> isExplored
                        && verdict(property.formula(), sends.only(Set.of(state)))
                                .isEmpty())
                .toList();
        FunctionSends since = alone.isEmpty() ? sends : sends.only(alone);
        State first = since.states().iterator().next();
        return new Finding(
                Rule.UNKNOWN_PROPERTY,
                new Element.OfState(Element.ModelRole.NEW, first),
                named(property) + " is unknown, since " + since.describe()
                        + (isExplored ? "" : ", which is too much to explore") + "; if nothing is sent, it "
                        + (holdsIfNothingIsSent(property.formula()) ? "holds" : "does not hold"),
                FunctionSends.REMEDY,
                wayTo(first));
    }

    private List<Turn> wayTo(State state) {
        return pairs.configurations().stream()
                .filter(at -> at.evolved().equals(state))
                .findFirst()
                .map(pairs::wayTo)
                .orElse(List.of());
    }

    private String named(Property property) {
        return "'" + property.name() + "' (" + file.file() + ", line " + property.line() + ")";
    }
}
