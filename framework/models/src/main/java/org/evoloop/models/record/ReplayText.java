package org.evoloop.models.record;

import java.time.ZoneId;
import java.util.ArrayList;
import java.util.List;
import org.evoloop.journal.DryRun;
import org.evoloop.journal.DryRun.Difference;
import org.evoloop.journal.Verdict;
import org.jspecify.annotations.Nullable;

/** What other models would have made of a journal's events, for people. */
public final class ReplayText {
    private ReplayText() {}

    /** Three lines for each event that differs, and how many there were. */
    public static String write(DryRun.Result result, ZoneId zone) {
        List<String> lines = new ArrayList<>();
        for (Difference each : result.differences()) {
            lines.add(RecordText.TIME.format(each.at().atZone(zone)) + "  " + each.occurrence());
            lines.add("  then  " + told(each.recorded(), "had no such timer"));
            lines.add("  now   " + told(each.other(), "would not have happened"));
        }
        lines.add(result.events() + " events, " + result.differences().size() + " decided otherwise");
        return String.join("\n", lines) + "\n";
    }

    private static String told(@Nullable Verdict verdict, String none) {
        return verdict == null ? none : verdict.toString();
    }
}
