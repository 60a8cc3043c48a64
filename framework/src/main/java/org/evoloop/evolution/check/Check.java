package org.evoloop.evolution.check;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.evoloop.evolution.DecisionTable;
import org.evoloop.evolution.ModelPair;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;

/**
 * Checks a pair of machines before it runs: all rules of {@link Rule} but {@link Rule#PROPERTY}.
 *
 * <p>Threading: none needed, it keeps nothing.
 */
public final class Check {
    private Check() {}

    /**
     * Every breach, ordered by rule and then as drawn. What depends on pairs of states is judged only if the pair is an
     * evolution, since otherwise no converter could run it.
     */
    public static List<Finding> run(CheckInput input) {
        ModelPair pair = input.pair();
        List<Finding> findings = new ArrayList<>();
        MachineRules original = new MachineRules(Element.Side.ORIGINAL, pair.original());
        MachineRules evolved = new MachineRules(Element.Side.NEW, pair.evolved());
        findings.addAll(original.findings());
        findings.addAll(evolved.findings());
        findings.addAll(evolved.traps(original.trapStates()));
        findings.addAll(original.traps(List.of()));
        findings.addAll(new ConverterRules(input, evolved).findings());
        List<Finding> conditions = conditions(pair);
        findings.addAll(conditions);
        if (conditions.isEmpty()) {
            DecisionTable table = DecisionTable.compile(pair, input.device());
            findings.addAll(new PairRules(input, table, original).findings());
        }
        findings.sort(Comparator.comparing(Finding::rule));
        return List.copyOf(findings);
    }

    private static List<Finding> conditions(ModelPair pair) {
        List<Finding> findings = new ArrayList<>();
        for (ModelPair.Violation violation : pair.violations()) {
            if (violation instanceof ModelPair.Violation.MissingEvent missing) {
                Event event = missing.event();
                findings.add(new Finding(
                        Rule.CONDITION_1,
                        new Element.OfEvent(Element.Side.ORIGINAL, event),
                        "event " + event + " of the original model is missing in the new model",
                        "use it there under the same name, capital letters and guards included"));
            } else if (violation instanceof ModelPair.Violation.MissingState missing) {
                State state = missing.state();
                findings.add(new Finding(
                        Rule.CONDITION_2,
                        new Element.OfState(Element.Side.ORIGINAL, state),
                        "state " + state + " of the original model is missing in the new model",
                        "draw it there under the same name, capital letters included"));
            }
        }
        State device = pair.original().initial();
        State system = pair.evolved().initial();
        if (!pair.deviceStates(system).contains(device)) {
            findings.add(new Finding(
                    Rule.INITIAL_DIFFERS,
                    new Element.OfState(Element.Side.NEW, system),
                    "the new model starts in " + system + ", the device in " + device,
                    "let the new model start in " + device));
        }
        return findings;
    }
}
