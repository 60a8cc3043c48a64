package org.evoloop.models.record;

import java.util.List;
import java.util.Map;
import org.evoloop.engine.Input;
import org.evoloop.evolution.Occurrence;
import org.evoloop.journal.JournalFiles.SegmentInfo;
import org.evoloop.journal.JournalRecord;
import org.evoloop.models.format.Json;
import org.jspecify.annotations.Nullable;

/** Journal records as JSON. */
public final class RecordJson {
    private RecordJson() {}

    /** The keys of a record, in this order. */
    private record Line(
            String segment,
            long record,
            int offset,
            String time,
            long nanos,
            String kind,
            @Nullable String event,
            @Nullable String source,
            Map<String, Object> values,
            @Nullable String text,
            String original,
            String evolved,
            @Nullable String doubt,
            List<String> endings) {}

    /** The keys of a segment, in this order. */
    private record Segment(
            String segment,
            String fingerprint,
            String original,
            String evolved,
            String begun,
            long records,
            boolean cutOff) {}

    /** A record on one line, without a line terminator. */
    public static String line(JournalRecord written) {
        Occurrence occurrence = occurrence(written);
        return Json.line(new Line(
                written.segment(),
                written.number(),
                written.offset(),
                written.at().toString(),
                written.nanos(),
                written.kind(),
                occurrence == null ? null : occurrence.label(),
                occurrence == null ? null : Json.word(occurrence.source()),
                occurrence == null ? Map.of() : occurrence.values().byName(),
                Json.orNull(InputText.of(written.input())),
                written.where().original().name(),
                written.where().evolved().name(),
                Json.orNull(written.doubt()),
                written.endings()));
    }

    /** A segment on one line, without a line terminator. */
    public static String line(SegmentInfo segment) {
        return Json.line(new Segment(
                segment.segment(),
                segment.fingerprint(),
                segment.original(),
                segment.evolved(),
                segment.begun().toString(),
                segment.records(),
                segment.cutOff()));
    }

    static @Nullable Occurrence occurrence(JournalRecord written) {
        return written.input() instanceof Input.Observed observed ? observed.occurrence() : null;
    }

    static String values(Occurrence occurrence) {
        return Json.line(occurrence.values().byName());
    }
}
