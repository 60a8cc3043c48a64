package org.evoloop.models.temporal;

import java.util.ArrayList;
import java.util.List;
import org.evoloop.check.CheckInput;
import org.evoloop.check.Element;
import org.evoloop.check.Finding;
import org.evoloop.check.PairGraph;
import org.evoloop.check.Rule;
import org.evoloop.check.properties.PropertyFile;
import org.evoloop.check.temporal.MomentGraph;
import org.evoloop.check.temporal.Property;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.DecisionTable;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Turn;

/** Checks the properties written beside the models. */
public final class PropertyCheck {
    private PropertyCheck() {}

    /**
     * Returns a finding for each property that does not hold, with the events that show it.
     *
     * @throws org.evoloop.statemachine.ModelException if the pair is not an evolution
     */
    public static List<Finding> run(CheckInput input, PropertyFile file) {
        ModelPair pair = input.pair();
        pair.requireValid();
        MomentGraph graph = new MomentGraph(new PairGraph(pair.initial(), DecisionTable.compile(pair, input.device())));
        ModelChecker checker = new ModelChecker(pair, graph);
        List<Finding> findings = new ArrayList<>();
        for (Property property : file.properties()) {
            if (!checker.holds(property.formula(), graph.initial())) {
                List<Turn> example = CounterExample.of(property.formula(), graph, checker);
                Configuration end = example.isEmpty()
                        ? pair.initial()
                        : example.get(example.size() - 1).decision().after();
                findings.add(new Finding(
                        Rule.PROPERTY,
                        new Element.OfState(Element.ModelRole.NEW, end.evolved()),
                        "'" + property.name() + "' (" + file.file() + ", line " + property.line() + ") does not hold",
                        "change the new model, or the property if it asks for too much",
                        example));
            }
        }
        return findings;
    }
}
