package org.evoloop.models;

import java.io.PrintWriter;
import java.time.DateTimeException;
import java.time.Instant;
import java.time.LocalDateTime;
import java.time.ZoneId;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.concurrent.Callable;
import org.evoloop.journal.JournalFiles;
import org.evoloop.journal.JournalRecord;
import org.evoloop.models.record.RecordJson;
import org.evoloop.models.record.RecordText;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** Prints the records, one per line. */
@Command(
        name = "show",
        description = "Prints the records, one line each: the time of day, the monotonic clock in seconds, the"
                + " converter's input, the states of both models after it, which events ended, and doubts.",
        mixinStandardHelpOptions = true)
@SuppressWarnings("NullAway.Init") // picocli sets the fields
final class JournalShowCommand implements Callable<Integer> {
    @Spec
    private CommandSpec spec;

    @Mixin
    private JournalDirectory journal;

    @Option(
            names = "--from",
            paramLabel = "TIME",
            description = "Skips earlier records; local time such as 2026-11-23T10:15, or UTC with a final Z.")
    private @Nullable String from;

    @Option(names = "--to", paramLabel = "TIME", description = "Skips records from this time on.")
    private @Nullable String to;

    @Option(names = "--last", paramLabel = "N", description = "Prints only the last N records.")
    private @Nullable Integer last;

    @Option(names = "--json", description = "Prints each record as JSON, one line each.")
    private boolean json;

    @Override
    public Integer call() throws Exception {
        Instant first = time("--from", from, Instant.MIN);
        Instant end = time("--to", to, Instant.MAX);
        Integer count = last;
        if (count != null && count < 1) {
            throw new IllegalArgumentException("--last is " + count + "; it must be at least 1");
        }
        return journal.examine(spec, files -> show(files, first, end, count == null ? Integer.MAX_VALUE : count));
    }

    private int show(JournalFiles files, Instant first, Instant end, int count) {
        Deque<JournalRecord> kept = new ArrayDeque<>();
        files.read(each -> {
            if (each.at().isBefore(first) || !each.at().isBefore(end)) {
                return;
            }
            if (count == Integer.MAX_VALUE) {
                print(each);
                return;
            }
            kept.add(each);
            if (kept.size() > count) {
                kept.remove();
            }
        });
        kept.forEach(this::print);
        spec.commandLine().getOut().flush();
        return 0;
    }

    private void print(JournalRecord each) {
        PrintWriter out = spec.commandLine().getOut();
        out.print((json ? RecordJson.line(each) : RecordText.line(each, ZoneId.systemDefault())) + "\n");
    }

    private static Instant time(String option, @Nullable String text, Instant usual) {
        if (text == null) {
            return usual;
        }
        try {
            return text.endsWith("Z")
                    ? Instant.parse(text)
                    : LocalDateTime.parse(text).atZone(ZoneId.systemDefault()).toInstant();
        } catch (DateTimeException mistake) {
            throw new IllegalArgumentException(
                    option + " is '" + text + "'; write a time as 2026-11-23T10:15 or 2026-11-23T09:15:30Z", mistake);
        }
    }
}
