package org.evoloop.models.record;

import java.time.Instant;
import java.time.ZoneId;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import org.evoloop.check.properties.PropertyFile;
import org.evoloop.check.temporal.Property;
import org.evoloop.journal.DryRun;
import org.evoloop.journal.DryRun.Broken;
import org.evoloop.journal.DryRun.Note;
import org.evoloop.rehearsal.Difference;
import org.evoloop.statemachine.Names;

/** A replay of a journal's events on other models as text. */
public final class ReplayText {
    private ReplayText() {}

    /**
     * A line for each reason that may cause differences besides the other models, three lines for each event that was
     * handled differently, one line for each property that is broken or open, and the totals.
     *
     * @param file the properties that were watched
     */
    public static String write(DryRun.Result result, PropertyFile file, ZoneId zone) {
        List<String> lines = new ArrayList<>();
        for (Note each : result.notes()) {
            lines.add("note: at " + time(each.at(), zone) + " " + each.why());
        }
        for (Difference each : result.differences()) {
            lines.add(time(each.at(), zone) + "  " + each.occurrence());
            lines.add("  then  " + each.then());
            lines.add("  now   " + each.now());
        }
        for (Broken each : result.broken()) {
            lines.add("broken: " + called(each.property(), file) + " at " + time(each.at(), zone) + ", " + each.by()
                    + ", in " + each.where());
        }
        for (Property each : result.open()) {
            lines.add("open: " + called(each, file) + ", since the journal ends before the required event came");
        }
        lines.add(sum(result, file));
        return lines.stream().map(Names::inOneLine).collect(Collectors.joining("\n", "", "\n"));
    }

    static String time(Instant at, ZoneId zone) {
        return RecordText.TIME.format(at.atZone(zone));
    }

    private static String called(Property property, PropertyFile file) {
        return "'" + property.name() + "' (" + file.file() + ", line " + property.line() + ")";
    }

    static String sum(DryRun.Result result, PropertyFile file) {
        int properties = file.properties().size();
        return result.events() + " events, " + result.differences().size() + " decided differently"
                + (properties == 0
                        ? ""
                        : "; " + properties + (properties == 1 ? " property, " : " properties, ")
                                + result.broken().size() + " broken, "
                                + result.open().size() + " open");
    }
}
