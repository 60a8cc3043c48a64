package org.evoloop.models.checking;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.evoloop.check.Element;
import org.evoloop.check.Finding;
import org.evoloop.check.RuleSwitches.SwitchedOff;
import org.evoloop.check.timing.TimeVerdict;
import org.evoloop.evolution.Turn;

/** Findings as text, one paragraph each. */
public final class FindingsText {
    private FindingsText() {}

    /**
     * The text for {@code findings}.
     *
     * @param off findings that were switched off
     * @param verdicts the results of time properties
     * @param places gives an element's place in its file
     */
    public static String write(
            List<Finding> findings,
            List<SwitchedOff> off,
            List<TimeVerdict> verdicts,
            Function<Element, String> places) {
        List<String> lines = new ArrayList<>();
        for (Finding finding : findings) {
            lines.add(finding.rule().severity().name().toLowerCase(Locale.ROOT) + ": "
                    + finding.rule().id() + ": " + finding.message());
            lines.add("  at:   " + places.apply(finding.element()));
            lines.add("  fix:  " + finding.remedy());
            if (!finding.example().isEmpty()) {
                lines.add("  way:  " + way(finding));
            }
            if (!finding.timed().isEmpty()) {
                lines.add("  way:  " + TimedExample.text(finding.timed()));
            }
        }
        for (SwitchedOff each : off) {
            lines.add(
                    "off: " + each.finding().rule().id() + ": " + each.finding().message());
            lines.add("  why:  " + each.reason() + " (" + each.where() + ")");
        }
        verdicts.forEach(verdict -> lines.add("time: " + verdict));
        lines.add((findings.isEmpty() ? "nothing found" : count(findings))
                + (off.isEmpty() ? "" : ", " + off.size() + " switched off"));
        return String.join("\n", lines) + "\n";
    }

    private static String way(Finding finding) {
        Turn first = finding.example().get(0);
        return first.decision().before()
                + finding.example().stream()
                        .map(turn -> " --" + turn.event() + (turn.deviceActed() ? " (the device acted)" : "") + "--> "
                                + turn.decision().after())
                        .collect(Collectors.joining());
    }

    private static String count(List<Finding> findings) {
        return findings.size() == 1 ? "1 finding" : findings.size() + " findings";
    }
}
