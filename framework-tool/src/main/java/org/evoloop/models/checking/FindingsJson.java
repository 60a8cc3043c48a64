package org.evoloop.models.checking;

import java.util.List;
import java.util.Locale;
import java.util.function.Function;
import org.evoloop.evolution.Turn;
import org.evoloop.evolution.check.Element;
import org.evoloop.evolution.check.Finding;
import org.evoloop.models.format.Json;

/** Findings for programs, in the shape that docs/models.md promises: components are the keys, in this order. */
public record FindingsJson(List<Row> findings) {

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

    /** An event and where it leads. */
    public record Happening(String event, boolean deviceActed, String originalState, String newState) {}

    /**
     * The text for {@code findings}.
     *
     * @param places where in a file an element stands
     */
    public static String write(List<Finding> findings, Function<Element, String> places) {
        return Json.write(new FindingsJson(
                findings.stream().map(finding -> row(finding, places)).toList()));
    }

    private static Row row(Finding finding, Function<Element, String> places) {
        return new Row(
                finding.rule().id(),
                finding.rule().severity().name().toLowerCase(Locale.ROOT),
                finding.element().side().name().toLowerCase(Locale.ROOT),
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
