package org.evoloop.console;

import static org.evoloop.console.StatusJson.lowerCase;

import java.io.PrintStream;
import java.time.Duration;
import java.time.ZoneId;
import java.time.format.DateTimeFormatter;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.evoloop.converter.ConverterStatus;
import org.evoloop.converter.ConverterStatus.ConversionTime;
import org.evoloop.converter.HistoryEntry;
import org.evoloop.converter.Trouble;
import org.evoloop.function.Reading;
import org.evoloop.loop.ComponentStatus;
import org.evoloop.loop.LoopState;
import org.evoloop.statemachine.Names;

/** The status of a converter, for people. */
final class StatusText {
    private static final DateTimeFormatter TIME_OF_DAY = DateTimeFormatter.ofPattern("HH:mm:ss.SSS", Locale.ROOT);

    private static final DateTimeFormatter SECOND = DateTimeFormatter.ofPattern("uuuu-MM-dd HH:mm:ss", Locale.ROOT);

    /** An event that took less is shown without the time when it was observed. */
    private static final Duration NOTICEABLE = Duration.ofSeconds(1);

    private static final int MOST_TROUBLES = 5;

    private StatusText() {}

    /** The most important parts: the states, current activity, the device, and any problem. */
    static void brief(ConverterStatus status, PrintStream out) {
        line(out, "converter", status.name() + ", " + lowerCase(status.loop()));
        line(out, "states", states(status));
        if (!status.evolution().isEmpty()) {
            line(out, "models", status.evolution());
        }
        if (!status.shadow().isEmpty()) {
            line(out, "shadow", status.shadow());
        }
        if (!status.doubt().isEmpty()) {
            line(out, "in doubt", status.doubt());
        }
        if (status.drift().unexplained() > 0) {
            line(out, "drift", status.drift().toString());
        }
        line(out, "now", now(status));
        if (!status.timers().isEmpty()) {
            line(out, "timers", timers(status));
        }
        ConverterStatus.LinkStatus link = status.link();
        if (link != null) {
            if (!link.up()) {
                line(out, "device", "unknown");
            } else if (!link.readings().isEmpty()) {
                line(out, "device", readings(link.readings()));
            }
            line(out, "link", (link.up() ? "up" : "down") + (link.text().isEmpty() ? "" : ", " + link.text()));
        }
        String trouble = trouble(status);
        if (!trouble.isEmpty()) {
            line(out, "trouble", trouble);
        }
    }

    /** The complete status. */
    static void all(ConverterStatus status, PrintStream out) {
        brief(status, out);
        if (!status.function().thread().isEmpty()) {
            line(out, "function", "thread " + status.function().thread());
        }
        line(
                out,
                "queue",
                status.events().waiting() + " waiting, highest "
                        + status.queue().highest() + ", room for "
                        + status.queue().capacity() + " presses; "
                        + status.events().dropped() + " dropped, "
                        + status.events().refused() + " refused");
        line(
                out,
                "events",
                status.events().handled() + " handled, "
                        + status.events().ignored() + " ignored, "
                        + status.events().stale() + " stale, "
                        + status.events().failed() + " failed, "
                        + status.events().inProgress() + " in progress, of "
                        + status.events().observed() + " observed");
        line(out, "conversion", conversionTime(status.conversionTime()));
        components(status.components(), out);
        for (ConverterStatus.Fault fault : status.faults()) {
            line(out, "fault", fault.part() + failures("  ", fault.failures(), fault.lastFailure()));
        }
    }

    /** In one line: the current states, and since when they are only the last known ones. */
    static String states(ConverterStatus status) {
        String shown = "original " + status.states().original() + ", new "
                + status.system()
                + status.lastKnownSince()
                        .map(since -> "; last known, since " + SECOND.format(since.atZone(ZoneId.systemDefault())))
                        .orElse("");
        return Names.inOneLine(shown);
    }

    private static String timers(ConverterStatus status) {
        return status.timers().stream()
                .map(ConverterStatus.RunningTimer::describe)
                .collect(Collectors.joining(", "));
    }

    private static String now(ConverterStatus status) {
        if (status.loop() != LoopState.RUNNING) {
            return "events are refused until start";
        }
        ConverterStatus.RunningFunction function = status.function();
        if (function.state().isEmpty()) {
            if (status.link() != null && !status.link().up()) {
                return "waiting for the device";
            }
            int waiting = status.queue().depth();
            return waiting == 0 ? "waiting for an event" : counted(waiting, "event") + " waiting to be converted";
        }
        String readings = readings(function.readings());
        String words = Stream.of(function.progress(), readings)
                .filter(text -> !text.isEmpty())
                .collect(Collectors.joining(", "));
        return function.state() + (words.isEmpty() ? " is running" : ": " + words);
    }

    /** All readings; false ones are combined: {@code battery 93 %, docked; not lifted or stuck}. */
    private static String readings(List<Reading> readings) {
        List<String> so = new ArrayList<>();
        List<String> not = new ArrayList<>();
        for (Reading reading : readings) {
            if (Boolean.FALSE.equals(reading.value())) {
                not.add(Reading.of(reading.name(), true).toString());
            } else if (!"none".equals(reading.value())) {
                so.add(reading.toString());
            }
        }
        String denied = String.join(", ", not).replaceFirst(", (?=[^,]*$)", " or ");
        return Stream.of(String.join(", ", so), denied.isEmpty() ? "" : "not " + denied)
                .filter(text -> !text.isEmpty())
                .collect(Collectors.joining("; "));
    }

    private static String trouble(ConverterStatus status) {
        // Those of link and record have lines of their own.
        List<String> found = status.troubles().stream()
                .filter(trouble ->
                        !trouble.part().equals(Trouble.LINK) && !trouble.part().equals(Trouble.RECORD))
                .map(Trouble::words)
                .collect(Collectors.toCollection(ArrayList::new));
        if (found.size() > MOST_TROUBLES) {
            int more = found.size() - MOST_TROUBLES;
            found.subList(MOST_TROUBLES, found.size()).clear();
            found.add(more + " more");
        }
        if (status.events().failed() > 0) {
            found.add(counted(status.events().failed(), "event") + " failed");
        }
        if (status.queue().dropped() > 0) {
            found.add(counted(status.queue().dropped(), "event") + " dropped");
        }
        return found.isEmpty() ? "" : String.join("; ", found) + "; see status --all and history";
    }

    private static String counted(long count, String what) {
        return count + " " + what + (count == 1 ? "" : "s");
    }

    private static String failures(String before, long count, String last) {
        return count == 0 ? "" : before + count + (count == 1 ? " failure: " : " failures, the last: ") + last;
    }

    private static void line(PrintStream out, String label, String text) {
        out.println(String.format(Locale.ROOT, "%-12s%s", label, Names.inOneLine(text)));
    }

    private static String conversionTime(ConversionTime time) {
        return time.events() == 0
                ? "none yet"
                : "last " + duration(time.lastNanos()) + ", median " + duration(time.medianNanos())
                        + ", 99th percentile " + duration(time.percentile99Nanos());
    }

    /** About three digits, in a suitable unit. */
    static String duration(long nanos) {
        double micros = nanos / 1e3;
        return micros < 999.5
                ? String.format(Locale.ROOT, "%.0f us", micros)
                : micros < 999_500
                        ? String.format(Locale.ROOT, "%.1f ms", micros / 1e3)
                        : String.format(Locale.ROOT, "%.1f s", micros / 1e6);
    }

    /** One line per component. */
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

    /** When a control was operated, if that was noticeably before the event ended. */
    private static String pressed(HistoryEntry entry) {
        return entry.occurrence().source().isButton() && entry.took().compareTo(NOTICEABLE) >= 0
                ? ", pressed " + TIME_OF_DAY.format(entry.observedAt().atZone(ZoneId.systemDefault()))
                : "";
    }

    /** One line per event. */
    static void history(List<HistoryEntry> entries, PrintStream out) {
        for (HistoryEntry entry : entries) {
            String change = entry.before().equals(entry.after())
                    ? "in " + entry.before()
                    : entry.before() + " -> " + entry.after();
            out.println(Names.inOneLine(
                    entry.number() + "  " + TIME_OF_DAY.format(entry.at().atZone(ZoneId.systemDefault())) + "  "
                            + entry.occurrence() + pressed(entry) + "  " + change + "  " + lowerCase(entry.outcome())
                            + (entry.detail().isEmpty() ? "" : ": " + entry.detail())));
        }
    }
}
