package org.evoloop.check;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.evoloop.evolution.DecisionTable;
import org.evoloop.evolution.ModelPair;

/**
 * Checks a pair of machines before it runs: all rules of {@link Rule} except {@link Rule#PROPERTY}, {@link
 * Rule#UNKNOWN_PROPERTY} and those about time, {@link Rule#TIME_DEADLOCK}, {@link Rule#TIMER_RACE} and {@link Rule#STEP_OUTLIVES_VISIT}.
 *
 * <p>Threading: thread-safe, since it has no state.
 *
 * @since 0.1
 */
public final class Check {
    private Check() {}

    /**
     * All findings, ordered by rule and then as drawn. Rules about pairs of states are checked only if the pair is an
     * evolution, since otherwise no converter could run it.
     */
    public static List<Finding> run(CheckInput input) {
        ModelPair pair = input.pair();
        List<Finding> findings = new ArrayList<>();
        MachineRules original = new MachineRules(Element.ModelRole.ORIGINAL, pair.original(), Set.of());
        MachineRules evolved = new MachineRules(Element.ModelRole.NEW, pair.evolved(), original.unreachable());
        findings.addAll(original.findings());
        // Findings that the new model shares with the device's are reported once, for the latter.
        Set<Breach> known = new HashSet<>();
        findings.forEach(finding -> known.add(Breach.of(finding)));
        evolved.findings().stream()
                .filter(finding -> !known.contains(Breach.of(finding)))
                .forEach(findings::add);
        findings.addAll(new ConverterRules(input, evolved).findings());
        List<Finding> conditions = new Conditions(pair).findings();
        findings.addAll(conditions);
        if (conditions.isEmpty()) {
            DecisionTable table = DecisionTable.compile(pair, input.device());
            PairGraph graph = new PairGraph(pair.initial(), table);
            findings.addAll(new PairRules(input, table, graph, original, evolved).findings());
            findings.addAll(new PairNotes(input, table, graph).findings());
            findings.addAll(new DeviceStateRules(input, graph).findings());
        }
        findings.sort(Comparator.comparing(Finding::rule));
        return List.copyOf(findings);
    }

    /** A finding without its machine. */
    private record Breach(Rule rule, Object part) {
        static Breach of(Finding finding) {
            return new Breach(finding.rule(), finding.element().part());
        }
    }
}
