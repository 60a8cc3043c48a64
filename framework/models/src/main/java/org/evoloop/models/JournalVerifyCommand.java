package org.evoloop.models;

import java.util.List;
import java.util.concurrent.Callable;
import org.evoloop.journal.JournalFiles;
import org.evoloop.journal.JournalFiles.SegmentInfo;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;

/** Checks that a journal is intact. */
@Command(
        name = "verify",
        description =
                "Reads the whole journal and checks it; exit status 1 if it is damaged: then prints the file, the place"
                        + " in it and the remedy.",
        mixinStandardHelpOptions = true)
@SuppressWarnings("NullAway.Init") // picocli sets the fields
final class JournalVerifyCommand implements Callable<Integer> {
    @Spec
    private CommandSpec spec;

    @Mixin
    private JournalDirectory journal;

    @Override
    public Integer call() throws Exception {
        return journal.examine(spec, this::verify);
    }

    private int verify(JournalFiles files) {
        List<SegmentInfo> segments = files.read(each -> {});
        StringBuilder text = new StringBuilder();
        long records = 0;
        for (SegmentInfo segment : segments) {
            records += segment.records();
            text.append(segment.segment() + ": " + segment.records() + " records since " + segment.begun() + " of '"
                    + segment.original() + "' and '" + segment.evolved() + "', fingerprint " + segment.fingerprint()
                    + (segment.cutOff() ? "; its last record is not complete and does not count" : "") + "\n");
        }
        return Output.print(spec, text + journal.path().toString() + " is sound: " + records + " records\n");
    }
}
