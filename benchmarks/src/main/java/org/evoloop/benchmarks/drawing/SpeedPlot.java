package org.evoloop.benchmarks.drawing;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;
import org.evoloop.benchmarks.report.Results;
import org.evoloop.benchmarks.report.Row;
import org.evoloop.benchmarks.report.Table;
import org.evoloop.svg.Svg;

/**
 * Plots a run: the time of a decision, ours and others', and the time of the loop compared with bare rings, each with
 * its goals. Each line is one contender, with a full dot for the usual case and a hollow one for the harder case.
 */
public final class SpeedPlot {
    private static final double WIDTH = 860;
    private static final double LEFT = 190;
    private static final double RIGHT = 215;
    private static final double HEAD = 92;
    private static final double PANEL_HEAD = 56;
    private static final double PANEL_FOOT = 40;
    private static final double FULL_COLUMN = WIDTH - 132;
    private static final double HOLLOW_COLUMN = WIDTH - 20;
    private static final double FONT_SIZE = 14;
    private static final double LINE_HEIGHT = 26;

    private static final String STYLE = """
            text { fill: #1b2733 }
            .title { font-size: 19px; font-weight: bold }
            .heading { font-size: 16px; font-weight: bold }
            .origin, .mark { fill: #57606a; font-size: 12px }
            .name, .value, .column { text-anchor: end }
            .column { fill: #57606a; font-size: 12px }
            .mark { text-anchor: middle }
            .ours { font-weight: bold; fill: #0b62a8 }
            .grid { stroke: #d8dee4 }
            .span { stroke-width: 3; stroke: #adb5bd }
            .full { fill: #57606a; stroke: #57606a; stroke-width: 2 }
            .hollow { fill: #fff; stroke: #57606a; stroke-width: 2 }
            .span.ours { stroke: #7fb2de }
            .full.ours { fill: #0b62a8; stroke: #0b62a8 }
            .hollow.ours { fill: #fff; stroke: #0b62a8 }
            .goal { stroke: #c2410c; stroke-width: 1.5; stroke-dasharray: 5 3 }
            .goalName { fill: #c2410c; font-size: 12px }
            .before { text-anchor: end }
            """;

    private final Svg svg;
    private double top = HEAD;

    private SpeedPlot(Svg svg) {
        this.svg = svg;
    }

    /**
     * The plot as an SVG document.
     *
     * @throws IllegalArgumentException if the results lack a row that is drawn
     */
    public static String svg(Results results) {
        List<Panel> panels = List.of(
                new Panel(
                        "One decision",
                        "6 states",
                        row(results, "a decision by the event's name"),
                        "10,000 states",
                        row(results, "a decision among 10,000 states")),
                new Panel(
                        "Once through four threads: the whole loop, and bare rings that only hand on",
                        "median",
                        row(results, "the whole loop, 4 threads, median"),
                        "99th percentile",
                        row(results, "the whole loop, 4 threads, 99th percentile")));
        double height = HEAD + panels.stream().mapToDouble(Panel::height).sum();
        SpeedPlot plot = new SpeedPlot(new Svg("How fast Evoloop is", WIDTH, height, FONT_SIZE, STYLE, ""));
        plot.svg
                .text("title", 20, 32, "Evoloop beside others, in one run; further left is faster")
                .text(
                        "origin",
                        20,
                        54,
                        results.origin().day() + ", commit " + results.origin().commit())
                .text("origin", 20, 71, results.origin().machine());
        panels.forEach(plot::draw);
        return plot.svg.toString();
    }

    private static Row row(Results results, String what) {
        return results.rows().stream()
                .filter(row -> row.what().equals(what))
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException(
                        "the results have no row \"" + what + "\"; plot a run of the suites decision and ring"));
    }

    /** Two rows with the same contenders. */
    private record Panel(String title, String fullName, Row full, String hollowName, Row hollow) {

        /** From fastest to slowest. */
        List<Contender> contenders() {
            List<Contender> contenders = new ArrayList<>();
            contenders.add(new Contender("Evoloop", full.ours(), hollow.ours(), true));
            full.peers()
                    .forEach((name, value) -> contenders.add(
                            new Contender(name, value, hollow.peers().getOrDefault(name, value), false)));
            contenders.sort(Comparator.comparingDouble(Contender::full));
            return contenders;
        }

        LogAxis axis() {
            DoubleStream values = contenders().stream()
                    .flatMapToDouble(contender -> DoubleStream.of(contender.full, contender.hollow));
            DoubleStream goals =
                    Stream.of(full, hollow).mapToDouble(row -> row.goal().limit());
            return LogAxis.over(DoubleStream.concat(values, goals), LEFT, WIDTH - LEFT - RIGHT);
        }

        double height() {
            return PANEL_HEAD + contenders().size() * LINE_HEIGHT + PANEL_FOOT;
        }
    }

    private record Contender(String name, double full, double hollow, boolean ours) {}

    private void draw(Panel panel) {
        LogAxis axis = panel.axis();
        List<Contender> contenders = panel.contenders();
        double first = top + PANEL_HEAD;
        double bottom = first + contenders.size() * LINE_HEIGHT;
        svg.text("heading", 20, top + 16, panel.title);
        for (double mark : axis.marks()) {
            svg.line("grid", axis.x(mark), first, axis.x(mark), bottom);
            svg.text(
                    "mark",
                    axis.x(mark),
                    bottom + 16,
                    duration(mark, panel.full.unit()).replaceFirst("\\.0+", ""));
        }
        goals(panel, axis, first, bottom);
        double y = first + LINE_HEIGHT / 2;
        for (Contender contender : contenders) {
            draw(contender, axis, y, panel.full.unit());
            y += LINE_HEIGHT;
        }
        legend(panel, first - 4);
        top += panel.height();
    }

    /** The labels are on opposite sides, since the goals are close together. */
    private void goals(Panel panel, LogAxis axis, double first, double bottom) {
        double full = panel.full.goal().limit();
        double hollow = panel.hollow.goal().limit();
        boolean fullIsLess = full <= hollow;
        goal("goal, " + panel.fullName + ": ", full, fullIsLess, panel, axis, first, bottom);
        goal("goal, " + panel.hollowName + ": ", hollow, !fullIsLess, panel, axis, first, bottom);
    }

    private void goal(
            String name, double goal, boolean before, Panel panel, LogAxis axis, double first, double bottom) {
        double x = axis.x(goal);
        svg.line("goal", x, first - 12, x, bottom);
        svg.text(
                before ? "goalName before" : "goalName",
                before ? x - 4 : x + 4,
                first - 4,
                name + duration(goal, panel.full.unit()));
    }

    private void draw(Contender contender, LogAxis axis, double y, String unit) {
        String ours = contender.ours ? " ours" : "";
        svg.text("name" + ours, LEFT - 14, y + 5, contender.name);
        svg.line("span" + ours, axis.x(contender.full), y, axis.x(contender.hollow), y);
        svg.circle("hollow" + ours, axis.x(contender.hollow), y, 5);
        svg.circle("full" + ours, axis.x(contender.full), y, 5);
        svg.text("value" + ours, FULL_COLUMN, y + 5, duration(contender.full, unit));
        svg.text("value" + ours, HOLLOW_COLUMN, y + 5, duration(contender.hollow, unit));
    }

    /** The headings of the number columns. */
    private void legend(Panel panel, double y) {
        svg.text("column", FULL_COLUMN, y, panel.fullName).circle("full", FULL_COLUMN - 6, y - 18, 5);
        svg.text("column", HOLLOW_COLUMN, y, panel.hollowName).circle("hollow", HOLLOW_COLUMN - 6, y - 18, 5);
    }

    /** In the unit that gives the shortest number. */
    static String duration(double value, String unit) {
        double nanos = unit.equals("us") ? value * 1e3 : value;
        if (nanos < 1e3) {
            return Table.number(nanos) + " ns";
        }
        return nanos < 1e6 ? Table.number(nanos / 1e3) + " µs" : Table.number(nanos / 1e6) + " ms";
    }
}
