package org.evoloop.benchmarks.report;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.ToDoubleFunction;
import org.evoloop.journal.Journal;
import tools.jackson.databind.json.JsonMapper;

/**
 * The results of a soak.
 *
 * <p>Threading: immutable.
 *
 * @param samples in order of time, 8 or more
 */
public record SoakResults(String machine, String commit, String day, List<SoakSample> samples) {
    /** How much the heap may vary from one collection to another. */
    private static final double SLACK_MEGABYTES = 2;

    /** The default size limit of a journal, plus the segment being written. */
    private static final double MOST_DISK_MEGABYTES =
            (Journal.DEFAULT_KEPT_BYTES + Journal.DEFAULT_SEGMENT_BYTES) / 1e6;

    public SoakResults {
        samples = List.copyOf(samples);
    }

    /** What has grown from the first quarter to the last, one line each; times are not checked. */
    public List<String> grown() {
        List<String> grown = new ArrayList<>();
        requireFlat("heap after a collection, in MB", SoakSample::heapMegabytes, SLACK_MEGABYTES, grown);
        requireFlat("threads", SoakSample::threads, 1, grown);
        requireFlat("open files", SoakSample::files, 1, grown);
        double disk = samples.get(samples.size() - 1).diskMegabytes();
        if (disk > MOST_DISK_MEGABYTES) {
            grown.add(String.format(Locale.ROOT, "journal: %.1f MB, more than %.1f", disk, MOST_DISK_MEGABYTES));
        }
        return grown;
    }

    private void requireFlat(String what, ToDoubleFunction<SoakSample> figure, double slack, List<String> grown) {
        int quarter = samples.size() / 4;
        double first = median(samples.subList(quarter / 2, quarter + quarter / 2), figure);
        double last = median(samples.subList(samples.size() - quarter, samples.size()), figure);
        if (last > first + slack) {
            grown.add(String.format(Locale.ROOT, "%s: from %.1f to %.1f", what, first, last));
        }
    }

    private static double median(List<SoakSample> some, ToDoubleFunction<SoakSample> figure) {
        double[] sorted = some.stream().mapToDouble(figure).sorted().toArray();
        return sorted[sorted.length / 2];
    }

    /** The results as JSON, for programs. */
    public String json() {
        return JsonMapper.builder().build().writerWithDefaultPrettyPrinter().writeValueAsString(this) + "\n";
    }
}
