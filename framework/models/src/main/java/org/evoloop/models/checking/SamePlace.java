package org.evoloop.models.checking;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.evoloop.check.Element;
import org.evoloop.check.Finding;
import org.evoloop.check.Rule;

/**
 * Makes one finding of those about the same thing in a drawing: a transition that leaves a state around others is many
 * transitions of the flat machine, and a state beside a region many states.
 */
public final class SamePlace {
    private static final int NAMED = 3;

    private SamePlace() {}

    /** What is equal in findings that have one cause. */
    private record Cause(Rule rule, Element.ModelRole side, String place, String event) {}

    /** The same findings, in order, of each cause one. */
    public static List<Finding> merge(List<Finding> findings, Drawings drawings) {
        Map<Object, List<Finding>> byCause = new LinkedHashMap<>();
        for (Finding finding : findings) {
            byCause.computeIfAbsent(cause(finding, drawings), key -> new ArrayList<>())
                    .add(finding);
        }
        return byCause.values().stream().map(SamePlace::one).toList();
    }

    /** The finding itself if nothing else has its cause. */
    private static Object cause(Finding finding, Drawings drawings) {
        Element element = finding.element();
        if (!drawings.show(element)) {
            return finding;
        }
        boolean stateAlone = finding.rule() == Rule.TRAP_STATE || finding.rule() == Rule.UNREACHABLE_STATE;
        if (element instanceof Element.OfTransition of) {
            String event = of.transition().event().toString();
            return new Cause(finding.rule(), element.side(), drawings.place(element), event);
        }
        return stateAlone ? new Cause(finding.rule(), element.side(), drawings.place(element), "") : finding;
    }

    private static Finding one(List<Finding> same) {
        Finding first = same.get(0);
        if (same.size() == 1) {
            return first;
        }
        String others = same.stream()
                .skip(1)
                .limit(NAMED)
                .map(finding -> finding.element().toString())
                .collect(Collectors.joining(", "));
        String more = same.size() > 1 + NAMED ? " and " + (same.size() - 1 - NAMED) + " more" : "";
        return new Finding(
                first.rule(),
                first.element(),
                first.message() + "; the same holds for " + others + more,
                first.mend(),
                first.example(),
                first.timed());
    }
}
