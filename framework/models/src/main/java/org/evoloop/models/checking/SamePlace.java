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
 * Merges findings about the same element of a drawing. Flattening turns a transition that leaves a composite state into
 * many transitions, and a state in one of several regions into many states.
 */
public final class SamePlace {
    private static final int NAMED = 3;

    private SamePlace() {}

    /** Findings with equal causes are merged. */
    private record Cause(Rule rule, Element.ModelRole side, String place, String event) {}

    /** The findings in order, one for each cause. */
    public static List<Finding> merge(List<Finding> findings, Drawings drawings) {
        Map<Object, List<Finding>> byCause = new LinkedHashMap<>();
        for (Finding finding : findings) {
            byCause.computeIfAbsent(cause(finding, drawings), key -> new ArrayList<>())
                    .add(finding);
        }
        return byCause.values().stream().map(SamePlace::one).toList();
    }

    /** The cause of the finding, or the finding itself if it cannot be merged. */
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
                first.remedy(),
                first.example(),
                first.timed());
    }
}
