package org.evoloop.models.record;

import com.fasterxml.jackson.annotation.JsonProperty;
import java.util.List;
import org.evoloop.evolution.Configuration;
import org.evoloop.journal.DryRun;
import org.evoloop.journal.DryRun.Difference;
import org.evoloop.journal.Verdict;
import org.evoloop.models.format.Json;
import org.jspecify.annotations.Nullable;

/** What other models would have made of a journal's events, for programs: components are the keys, in this order. */
public record ReplayJson(long events, List<Row> differences) {

    /** An event that differs; null for what would not have happened. */
    public record Row(
            String time,
            String event,
            String source,
            @Nullable Told then,
            @Nullable Told now) {}

    /** What became of it. */
    public record Told(
            Where before,
            Where after,
            String outcome,
            List<String> sent,
            @Nullable String why) {}

    /** The states of both models. */
    public record Where(
            String original, @JsonProperty("new") String evolved) {}

    /** All differences, in order. */
    public static String write(DryRun.Result result) {
        return Json.write(new ReplayJson(
                result.events(),
                result.differences().stream().map(ReplayJson::row).toList()));
    }

    private static Row row(Difference each) {
        return new Row(
                each.at().toString(),
                each.occurrence().label(),
                Json.word(each.occurrence().source()),
                told(each.recorded()),
                told(each.other()));
    }

    private static @Nullable Told told(@Nullable Verdict verdict) {
        return verdict == null
                ? null
                : new Told(
                        where(verdict.before()),
                        where(verdict.after()),
                        Json.word(verdict.outcome()),
                        verdict.sent(),
                        Json.orNull(verdict.why()));
    }

    private static Where where(Configuration at) {
        return new Where(at.original().name(), at.evolved().name());
    }
}
