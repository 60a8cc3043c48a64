package org.evoloop.models.checking;

import java.util.List;
import java.util.Locale;
import java.util.function.Function;
import org.evoloop.check.Element;
import org.evoloop.check.Finding;
import org.evoloop.check.RuleSwitches.SwitchedOff;
import org.evoloop.check.TimedEvent;
import org.evoloop.check.timing.Span;
import org.evoloop.check.timing.TimeVerdict;
import org.evoloop.evolution.Turn;
import org.evoloop.models.format.Json;
import org.jspecify.annotations.Nullable;

/** Findings as JSON, in the shape that docs/models.md promises: components are the keys, in this order. */
public record FindingsJson(List<Row> findings, List<OffRow> switchedOff, List<Verdict> times) {

    /**
     * A finding.
     *
     * @param machine {@code original} or {@code new}
     * @param example the events from the start to the finding; often empty
     * @param timed the same with times, where they matter
     */
    public record Row(
            String rule,
            String severity,
            String machine,
            String element,
            String place,
            String message,
            String remedy,
            List<Happening> example,
            List<Timed> timed) {}

    /** A finding that its author has switched off; {@code where} is the place of that setting. */
    public record OffRow(String rule, String machine, String element, String message, String reason, String where) {}

    /**
     * The result of a time property. {@code worstNanos} is null if there is no bound; both times are null if the
     * measured situation never occurs. What the worst would be if no event were urgent is the same where that makes no
     * difference.
     */
    public record Verdict(
            String property,
            int line,
            boolean holds,
            @Nullable Long bestNanos,
            @Nullable Long worstNanos,
            @Nullable Long worstNanosIfNothingUrgent,
            long moments) {}

    /**
     * Something that happens at a time; {@code sending} is the event on its way to the device at that time, or null.
     */
    public record Timed(
            long atNanos,
            String what,
            String originalState,
            String newState,
            @Nullable String sending) {}

    /** An event and the states after it. */
    public record Happening(String event, boolean deviceActed, String originalState, String newState) {}

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
        return Json.write(new FindingsJson(
                findings.stream().map(finding -> row(finding, places)).toList(),
                off.stream().map(FindingsJson::row).toList(),
                verdicts.stream().map(FindingsJson::verdict).toList()));
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
                finding.remedy(),
                finding.example().stream().map(FindingsJson::happening).toList(),
                finding.timed().stream().map(FindingsJson::timed).toList());
    }

    private static Verdict verdict(TimeVerdict verdict) {
        return new Verdict(
                verdict.property().name(),
                verdict.property().line(),
                verdict.holds(),
                verdict.best() < 0 ? null : verdict.best(),
                bounded(verdict.worst()),
                bounded(verdict.worstIfNothingUrgent()),
                verdict.moments());
    }

    private static @Nullable Long bounded(long nanos) {
        return nanos < 0 || nanos == Span.FOR_EVER ? null : nanos;
    }

    private static Timed timed(TimedEvent event) {
        return new Timed(
                event.atNanos(),
                event.what(),
                event.after().original().name(),
                event.after().evolved().name(),
                event.step().isEmpty() ? null : event.step());
    }

    private static Happening happening(Turn turn) {
        return new Happening(
                turn.event().toString(),
                turn.deviceActed(),
                turn.decision().after().original().name(),
                turn.decision().after().evolved().name());
    }
}
