package org.evoloop.check.timing;

import java.util.List;
import org.evoloop.check.Finding;

/**
 * What was found out about an evolution in time.
 *
 * <p>Threading: immutable.
 *
 * @param verdicts one for each time property, in order
 * @param findings what is wrong
 * @param undecided a message for each property that could not be decided, since the models are too large
 * @param note what else could not be looked at, for people; empty if all was
 * @since 0.1
 */
public record TimeReport(List<TimeVerdict> verdicts, List<Finding> findings, List<String> undecided, String note) {
    /** Nothing is timed. */
    public static final TimeReport NONE = new TimeReport(List.of(), List.of(), List.of(), "");

    public TimeReport {
        verdicts = List.copyOf(verdicts);
        findings = List.copyOf(findings);
        undecided = List.copyOf(undecided);
    }
}
