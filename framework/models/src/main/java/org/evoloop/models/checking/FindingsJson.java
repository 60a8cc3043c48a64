package org.evoloop.models.checking;

import java.util.List;
import java.util.Locale;
import java.util.function.Function;
import org.evoloop.check.Element;
import org.evoloop.check.Finding;
import org.evoloop.check.RuleSwitches.SwitchedOff;
import org.evoloop.evolution.Turn;
import org.evoloop.models.format.Json;

/** Findings for programs, in the shape that docs/models.md promises: components are the keys, in this order. */
public record FindingsJson(List<Row> findings, List<OffRow> switchedOff) {

    /**
     * A finding.
     *
     * @param machine {@code original} or {@code new}
     * @param example what happens until it shows, from the start; often nothing
     */
    public record Row(
            String rule,
            String severity,
            String machine,
            String element,
            String place,
            String message,
            String mend,
            List<Happening> example) {}

    /** A finding that its author has switched off; {@code where} the switch stands. */
    public record OffRow(String rule, String machine, String element, String message, String reason, String where) {}

    /** An event and where it leads. */
    public record Happening(String event, boolean deviceActed, String originalState, String newState) {}

    /**
     * The text for {@code findings}.
     *
     * @param off findings that do not count
     * @param places where in a file an element stands
     */
    public static String write(List<Finding> findings, List<SwitchedOff> off, Function<Element, String> places) {
        return Json.write(new FindingsJson(
                findings.stream().map(finding -> row(finding, places)).toList(),
                off.stream().map(FindingsJson::row).toList()));
    }

    private static OffRow row(SwitchedOff off) {
        Finding finding = off.finding();
        return new OffRow(
                finding.rule().id(),
                side(finding),
                finding.element().toString(),
                finding.message(),
                off.reason(),
                off.where());
    }

    private static String side(Finding finding) {
        return finding.element().side().name().toLowerCase(Locale.ROOT);
    }

    private static Row row(Finding finding, Function<Element, String> places) {
        return new Row(
                finding.rule().id(),
                finding.rule().severity().name().toLowerCase(Locale.ROOT),
                side(finding),
                finding.element().toString(),
                places.apply(finding.element()),
                finding.message(),
                finding.mend(),
                finding.example().stream().map(FindingsJson::happening).toList());
    }

    private static Happening happening(Turn turn) {
        return new Happening(
                turn.event().toString(),
                turn.deviceActed(),
                turn.decision().after().original().name(),
                turn.decision().after().evolved().name());
    }
}
