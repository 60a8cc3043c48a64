package org.evoloop.check.timing;

import java.util.List;
import org.evoloop.check.Finding;

/**
 * The results of the time check of an evolution.
 *
 * <p>Threading: immutable.
 *
 * @param verdicts one for each time property, in order
 * @param findings the problems
 * @param undecided a message for each property that could not be decided, since the models are too large
 * @param note what else could not be checked, for people; empty if everything was
 * @since 0.1
 */
public record TimeReport(List<TimeVerdict> verdicts, List<Finding> findings, List<String> undecided, String note) {
    /** The report for models without time. */
    public static final TimeReport NONE = new TimeReport(List.of(), List.of(), List.of(), "");

    public TimeReport {
        verdicts = List.copyOf(verdicts);
        findings = List.copyOf(findings);
        undecided = List.copyOf(undecided);
    }

    /** A copy whose verdicts say what they would be if no event were urgent, as far as that could be decided. */
    TimeReport beside(TimeReport nothingUrgent) {
        List<TimeVerdict> both = verdicts.stream()
                .map(verdict -> nothingUrgent.verdicts.stream()
                        .filter(other -> other.property().equals(verdict.property()))
                        .findFirst()
                        .map(verdict::beside)
                        .orElse(verdict))
                .toList();
        return new TimeReport(both, findings, undecided, note);
    }
}
