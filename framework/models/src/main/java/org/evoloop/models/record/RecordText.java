package org.evoloop.models.record;

import java.time.ZoneId;
import java.time.format.DateTimeFormatter;
import java.util.Locale;
import org.evoloop.journal.JournalRecord;
import org.evoloop.statemachine.Names;

/** Journal records as text, one line each. */
public final class RecordText {
    static final DateTimeFormatter TIME = DateTimeFormatter.ofPattern("uuuu-MM-dd HH:mm:ss.SSSSSS", Locale.ROOT);

    private RecordText() {}

    /**
     * A record on one line, without a line terminator: time of day, monotonic clock in seconds, kind, content, the
     * converter's states, the events that ended, and doubts.
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
        // Names and a component's text may contain line breaks, but a record is one line.
        return Names.inOneLine(line.toString());
    }
}
