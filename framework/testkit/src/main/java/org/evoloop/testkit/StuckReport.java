package org.evoloop.testkit;

import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import org.evoloop.converter.ConverterStatus;
import org.evoloop.converter.HistoryEntry;
import org.evoloop.evolution.Configuration;
import org.evoloop.loop.QueueStatus;
import org.jspecify.annotations.Nullable;

/** Describes where a converter is stuck, for an error message. */
final class StuckReport {
    private static final int LAST_ENTRIES = 6;
    private static final int LAST_LINES = 14;

    private final ConverterHarness harness;
    private final @Nullable SimulatedDevice device;
    private final TranscriptRecorder transcript;
    private final StringBuilder text = new StringBuilder();

    StuckReport(ConverterHarness harness, @Nullable SimulatedDevice device, TranscriptRecorder transcript) {
        this.harness = harness;
        this.device = device;
        this.transcript = transcript;
    }

    static String describe(Configuration states) {
        return "device " + states.original() + ", system " + states.evolved();
    }

    String text(String what) {
        text.append(what);
        ConverterStatus status = harness.status();
        line("states", describe(status.states()));
        if (device != null) {
            line("truth", "device " + device);
        }
        if (!status.doubt().isEmpty()) {
            line("in doubt", status.doubt());
        }
        queue(status.queue());
        line(
                "time",
                seconds(harness.clock().nanoTime()) + " of the clock; "
                        + harness.clock()
                                .untilNext()
                                .map(next -> "next is due in " + seconds(next.toNanos()))
                                .orElse("nothing is due"));
        lines("failures", harness.failures().stream().map(Object::toString).toList(), LAST_ENTRIES);
        lines("history", harness.history().stream().map(StuckReport::entry).toList(), LAST_ENTRIES);
        if (transcript.isAvailable()) {
            lines(
                    "transcript",
                    transcript.lines().stream().filter(line -> !line.isBlank()).toList(),
                    LAST_LINES);
        }
        return text.toString();
    }

    private void queue(QueueStatus queue) {
        line(
                "queue",
                queue.depth() + " waiting, room for " + queue.capacity() + " presses; " + queue.dropped() + " lost, "
                        + queue.refused() + " refused");
    }

    private static String seconds(long nanos) {
        return String.format(Locale.ROOT, "%.3f s", nanos / 1e9);
    }

    private static String entry(HistoryEntry entry) {
        return entry.occurrence() + ": " + entry.outcome() + ", " + describe(entry.before()) + " -> "
                + describe(entry.after()) + (entry.detail().isEmpty() ? "" : " (" + entry.detail() + ")");
    }

    private void line(String label, String value) {
        text.append("\n  ").append(label).append(": ").append(value);
    }

    private void lines(String label, List<String> all, int most) {
        if (!all.isEmpty()) {
            List<String> last = all.subList(Math.max(0, all.size() - most), all.size());
            line(
                    label + (last.size() < all.size() ? ", last " + last.size() + " of " + all.size() : ""),
                    last.stream().map(each -> "\n    " + each).collect(Collectors.joining()));
        }
    }
}
