package org.evoloop.benchmarks.report;

import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;

/** The rows as a text table. */
public final class Table {
    private static final String LINE = "%-52s %12s %-28s %9s %-9s %s%n";

    private Table() {}

    /** One line per row; the figures of the peers are below it. */
    public static String text(List<Row> rows) {
        StringBuilder text = new StringBuilder(
                String.format(Locale.ROOT, LINE, "what", "ours", "against", "ratio", "reach", "reached"));
        for (Row row : rows) {
            Row.Goal goal = row.goal();
            text.append(String.format(
                    Locale.ROOT,
                    LINE,
                    row.what(),
                    number(row.ours()) + " " + row.unit(),
                    goal.isRatio() ? goal.name() + " " + number(goal.against()) : "",
                    goal.isRatio() ? number(goal.ratio(row.ours())) : "",
                    (goal.atLeast() ? ">= " : "<= ") + number(goal.bound()),
                    row.reached() ? "yes" : "NO"));
            if (!row.peers().isEmpty()) {
                text.append("    ")
                        .append(row.peers().entrySet().stream()
                                .map(peer -> peer.getKey() + " " + number(peer.getValue()))
                                .collect(Collectors.joining(", ")))
                        .append(System.lineSeparator());
            }
        }
        return text.toString();
    }

    /** Rounded to three significant digits. */
    public static String number(double value) {
        String form = value >= 100 ? "%.0f" : value >= 10 ? "%.1f" : value >= 0.01 || value == 0 ? "%.2f" : "%.1e";
        return String.format(Locale.ROOT, form, value);
    }
}
