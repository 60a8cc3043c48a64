package org.evoloop.console;

import static org.evoloop.console.StatusJson.lowerCase;

import java.io.PrintStream;
import java.time.ZoneId;
import java.time.format.DateTimeFormatter;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import org.evoloop.converter.ConverterStatus;
import org.evoloop.converter.ConverterStatus.ConversionTime;
import org.evoloop.converter.HistoryEntry;
import org.evoloop.function.Reading;
import org.evoloop.loop.ComponentStatus;
import org.jspecify.annotations.Nullable;

/** What a converter tells of itself, for people. */
final class StatusText {
    private static final DateTimeFormatter TIME_OF_DAY = DateTimeFormatter.ofPattern("HH:mm:ss.SSS", Locale.ROOT);

    private static final DateTimeFormatter SECOND = DateTimeFormatter.ofPattern("uuuu-MM-dd HH:mm:ss", Locale.ROOT);

    private StatusText() {}

    static void status(ConverterStatus status, PrintStream out) {
        line(out, "converter", status.name() + ", " + lowerCase(status.loop()));
        line(
                out,
                "states",
                "original " + status.states().original() + ", new "
                        + status.states().evolved()
                        + status.lastKnownSince()
                                .map(since ->
                                        "; last known, since " + SECOND.format(since.atZone(ZoneId.systemDefault())))
                                .orElse(""));
        if (!status.doubt().isEmpty()) {
            line(out, "in doubt", status.doubt());
        }
        line(
                out,
                "queue",
                status.queue().depth() + " of " + status.queue().capacity()
                        + " waiting, highest " + status.queue().highest()
                        + "; " + status.queue().dropped() + " dropped, "
                        + status.queue().refused() + " refused");
        line(
                out,
                "events",
                status.events().handled() + " handled, "
                        + status.events().ignored() + " ignored, "
                        + status.events().stale() + " stale, "
                        + status.events().failed() + " failed");
        line(out, "conversion", conversionTime(status.conversionTime()));
        line(out, "function", function(status.function()));
        line(out, "link", link(status.link()));
        if (status.link() != null && !status.link().readings().isEmpty()) {
            line(
                    out,
                    "device",
                    status.link().readings().stream().map(Reading::toString).collect(Collectors.joining(", ")));
        }
        components(status.components(), out);
        for (ConverterStatus.Fault fault : status.faults()) {
            line(out, "fault", fault.part() + failures("  ", fault.failures(), fault.lastFailure()));
        }
    }

    private static String failures(String before, long count, String last) {
        return count == 0 ? "" : before + count + (count == 1 ? " failure: " : " failures, the last: ") + last;
    }

    private static void line(PrintStream out, String label, String text) {
        out.println(String.format(Locale.ROOT, "%-12s%s", label, text));
    }

    private static String conversionTime(ConversionTime time) {
        return time.events() == 0
                ? "none yet"
                : "last " + duration(time.lastNanos()) + ", median " + duration(time.medianNanos())
                        + ", 99th percentile " + duration(time.percentile99Nanos());
    }

    /** Three digits or so, in the unit that fits. */
    static String duration(long nanos) {
        double micros = nanos / 1e3;
        return micros < 999.5
                ? String.format(Locale.ROOT, "%.0f us", micros)
                : micros < 999_500
                        ? String.format(Locale.ROOT, "%.1f ms", micros / 1e3)
                        : String.format(Locale.ROOT, "%.1f s", micros / 1e6);
    }

    private static String function(ConverterStatus.RunningFunction function) {
        if (function.state().isEmpty()) {
            return "none";
        }
        return function.state()
                + (function.thread().isEmpty() ? ", no thread" : ", thread " + function.thread())
                + (function.describe().isEmpty() ? "" : ": " + function.describe());
    }

    private static String link(ConverterStatus.@Nullable LinkStatus link) {
        if (link == null) {
            return "none";
        }
        return (link.up() ? "up" : "down") + (link.text().isEmpty() ? "" : ", " + link.text());
    }

    /** A line a component. */
    static void components(List<ComponentStatus> components, PrintStream out) {
        int widest = components.stream()
                .mapToInt(component -> component.name().length())
                .max()
                .orElse(1);
        for (ComponentStatus component : components) {
            String failures = failures("  ", component.failures(), component.lastFailure());
            line(
                    out,
                    lowerCase(component.role()),
                    String.format(
                            Locale.ROOT,
                            "%-" + widest + "s  %-7s  %s%s",
                            component.name(),
                            lowerCase(component.activity()),
                            component.thread().isEmpty() ? "no thread" : component.thread(),
                            failures));
        }
    }

    /** A line an event. */
    static void history(List<HistoryEntry> entries, PrintStream out) {
        for (HistoryEntry entry : entries) {
            String change = entry.before().equals(entry.after())
                    ? "in " + entry.before()
                    : entry.before() + " -> " + entry.after();
            out.println(entry.number() + "  " + TIME_OF_DAY.format(entry.at().atZone(ZoneId.systemDefault())) + "  "
                    + entry.occurrence() + "  " + change + "  " + lowerCase(entry.outcome())
                    + (entry.detail().isEmpty() ? "" : ": " + entry.detail()));
        }
    }
}
