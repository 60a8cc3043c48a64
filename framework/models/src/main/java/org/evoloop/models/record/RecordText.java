package org.evoloop.models.record;

import java.time.ZoneId;
import java.time.format.DateTimeFormatter;
import java.util.Locale;
import org.evoloop.journal.JournalRecord;

/** Records for people, one line each. */
public final class RecordText {
    static final DateTimeFormatter TIME = DateTimeFormatter.ofPattern("uuuu-MM-dd HH:mm:ss.SSSSSS", Locale.ROOT);

    private RecordText() {}

    /**
     * The line without its end: time of day, monotonic clock in seconds, kind, what it is, where the converter was
     * then, which events ended, and doubts.
     */
    public static String line(JournalRecord shown, ZoneId zone) {
        String what = InputText.of(shown.input());
        StringBuilder line = new StringBuilder(TIME.format(shown.at().atZone(zone)))
                .append(String.format(Locale.ROOT, " %15.6f  %-10s", shown.nanos() / 1e9, shown.kind()))
                .append(what.isEmpty() ? "" : " " + what)
                .append("  at ")
                .append(shown.where());
        shown.endings().forEach(ending -> line.append("  | ").append(ending));
        if (!shown.doubt().isEmpty()) {
            line.append("  IN DOUBT: ").append(shown.doubt());
        }
        // A record is one line, whatever a component has said.
        return line.toString().replaceAll("\\R", " ");
    }
}
