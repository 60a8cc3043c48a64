package org.evoloop.benchmarks;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Locale;
import org.openjdk.jmh.results.RunResult;
import org.openjdk.jmh.util.Statistics;

/** The results as a table for people: a line a benchmark, and what they were measured with. */
final class ResultTable {
    private static final String BYTES = "gc.alloc.rate.norm";

    private final List<String> lines = new ArrayList<>();

    ResultTable() {
        line("benchmark", "p50", "p99", "mean", "unit", "bytes/event");
    }

    static String of(Collection<RunResult> results, String foot) {
        ResultTable table = new ResultTable();
        results.forEach(table::add);
        return String.join("", table.lines) + System.lineSeparator() + foot;
    }

    private void add(RunResult result) {
        String name = result.getParams().getBenchmark();
        String benchmark = name.substring(ResultTable.class.getPackageName().length() + 1);
        double bytes = result.getSecondaryResults().containsKey(BYTES)
                ? result.getSecondaryResults().get(BYTES).getScore()
                : 0;
        if (result.getSecondaryResults().containsKey(EventPathProfiler.LABEL)) {
            path(
                    benchmark,
                    result.getSecondaryResults().get(EventPathProfiler.LABEL).getStatistics(),
                    bytes);
        } else {
            line(benchmark, "-", "-", number(result.getPrimaryResult().getScore()), "ns", number(bytes));
        }
    }

    private void path(String benchmark, Statistics micros, double bytes) {
        line(
                benchmark,
                number(micros.getPercentile(50)),
                number(micros.getPercentile(99)),
                number(micros.getMean()),
                "us",
                number(bytes));
    }

    private static String number(double value) {
        return String.format(Locale.ROOT, value < 100 ? "%.2f" : "%.0f", value);
    }

    private void line(String benchmark, String p50, String p99, String mean, String unit, String bytes) {
        lines.add(String.format(Locale.ROOT, "%-36s %9s %9s %9s  %-4s %11s%n", benchmark, p50, p99, mean, unit, bytes));
    }
}
