package org.evoloop.models.record;

import com.fasterxml.jackson.annotation.JsonProperty;
import java.util.List;
import org.evoloop.check.properties.PropertyFile;
import org.evoloop.check.temporal.Property;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Occurrence;
import org.evoloop.journal.DryRun;
import org.evoloop.models.format.Json;
import org.evoloop.rehearsal.Difference;
import org.evoloop.rehearsal.Verdict;
import org.jspecify.annotations.Nullable;

/** A replay of a journal's events on other models as JSON: components are the keys, in this order. */
public record ReplayJson(long events, List<Row> differences, List<Standing> properties, List<Note> notes) {

    /** An event that was handled differently. {@code then} or {@code now} is null where the event did not occur. */
    public record Row(
            String time,
            String event,
            String source,
            @Nullable Handling then,
            @Nullable Handling now) {}

    /** Why differences from here on may come from something else than the other models. */
    public record Note(String time, String why) {}

    /** How the event was handled. */
    public record Handling(
            Where before,
            Where after,
            String outcome,
            List<String> sent,
            @Nullable String why) {}

    /** The states of both models. */
    public record Where(
            String original, @JsonProperty("new") String evolved) {}

    /**
     * A property of the other models: {@code kept}, {@code open} or {@code broken}. The values after {@code standing}
     * are null unless it was broken.
     */
    public record Standing(
            String name,
            String file,
            int line,
            String standing,
            @Nullable String time,
            @Nullable String event,
            @Nullable String source,
            @Nullable Where at) {}

    /**
     * All differences, in order.
     *
     * @param file the properties that were watched
     */
    public static String write(DryRun.Result result, PropertyFile file) {
        return Json.write(new ReplayJson(
                result.events(),
                result.differences().stream().map(ReplayJson::row).toList(),
                file.properties().stream()
                        .map(property -> standing(property, file.file(), result))
                        .toList(),
                result.notes().stream()
                        .map(note -> new Note(note.at().toString(), note.why()))
                        .toList()));
    }

    private static Standing standing(Property property, String file, DryRun.Result result) {
        for (DryRun.Broken broken : result.broken()) {
            if (broken.property().equals(property)) {
                Occurrence by = broken.occurrence();
                return new Standing(
                        property.name(),
                        file,
                        property.line(),
                        "broken",
                        broken.at().toString(),
                        by == null ? null : by.label(),
                        by == null ? null : Json.word(by.source()),
                        where(broken.where()));
            }
        }
        String standing = result.open().contains(property) ? "open" : "kept";
        return new Standing(property.name(), file, property.line(), standing, null, null, null, null);
    }

    private static Row row(Difference each) {
        return new Row(
                each.at().toString(),
                each.occurrence().label(),
                Json.word(each.occurrence().source()),
                handling(each.recorded()),
                handling(each.other()));
    }

    private static @Nullable Handling handling(@Nullable Verdict verdict) {
        return verdict == null
                ? null
                : new Handling(
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
