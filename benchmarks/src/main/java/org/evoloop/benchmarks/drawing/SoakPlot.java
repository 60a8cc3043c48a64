package org.evoloop.benchmarks.drawing;

import java.util.List;
import java.util.function.ToDoubleFunction;
import org.evoloop.benchmarks.report.SoakResults;
import org.evoloop.benchmarks.report.SoakSample;
import org.evoloop.benchmarks.report.Table;
import org.evoloop.svg.Svg;

/** Plots a soak: one panel for each figure, from the first event to the last. */
public final class SoakPlot {
    private static final double WIDTH = 860;
    private static final double LEFT = 250;
    private static final double RIGHT = 110;
    private static final double HEAD = 92;
    private static final double PANEL = 74;
    private static final double PANEL_HEIGHT = 48;
    private static final double FONT_SIZE = 14;
    private static final String STYLE = """
            text { fill: #1b2733 }
            .title { font-size: 19px; font-weight: bold }
            .origin { fill: #57606a; font-size: 12px }
            .name { text-anchor: end }
            .frame { stroke: #d8dee4; fill: none }
            .base { stroke: #adb5bd }
            .curve { stroke: #0b62a8; stroke-width: 2 }
            """;

    /** One panel, from zero to slightly above the maximum. */
    private record Panel(String name, ToDoubleFunction<SoakSample> figure) {}

    private static final List<Panel> PANELS = List.of(
            new Panel("heap after a collection, MB", SoakSample::heapMegabytes),
            new Panel("threads", SoakSample::threads),
            new Panel("open files", SoakSample::files),
            new Panel("journal on disk, MB", SoakSample::diskMegabytes),
            new Panel("monitor to execute, median, µs", SoakSample::medianMicros),
            new Panel("99th percentile, µs", SoakSample::percentile99Micros),
            new Panel("99.9th percentile, µs", SoakSample::percentile999Micros));

    private SoakPlot() {}

    /** The plot as an SVG document. */
    public static String svg(SoakResults results) {
        List<SoakSample> samples = results.samples();
        SoakSample last = samples.get(samples.size() - 1);
        Svg svg = new Svg("A converter over a long time", WIDTH, HEAD + PANELS.size() * PANEL, FONT_SIZE, STYLE, "");
        svg.text("title", 20, 32, String.format("%,d events with a journal, in %.0f s", last.events(), last.seconds()))
                .text("origin", 20, 54, results.day() + ", commit " + results.commit())
                .text("origin", 20, 71, results.machine());
        double top = HEAD;
        for (Panel panel : PANELS) {
            draw(svg, panel, samples, top);
            top += PANEL;
        }
        return svg.toString();
    }

    private static void draw(Svg svg, Panel panel, List<SoakSample> samples, double top) {
        double bottom = top + PANEL_HEIGHT;
        double most = samples.stream().mapToDouble(panel.figure).max().orElse(1);
        double scale = PANEL_HEIGHT / Math.max(most * 1.15, 1e-9);
        double width = WIDTH - LEFT - RIGHT;
        long events = samples.get(samples.size() - 1).events();
        svg.text("name", LEFT - 14, top + PANEL_HEIGHT / 2 + 5, panel.name);
        svg.line("base", LEFT, bottom, LEFT + width, bottom);
        for (int index = 1; index < samples.size(); index++) {
            SoakSample from = samples.get(index - 1);
            SoakSample to = samples.get(index);
            svg.line(
                    "curve",
                    LEFT + width * from.events() / events,
                    bottom - scale * panel.figure.applyAsDouble(from),
                    LEFT + width * to.events() / events,
                    bottom - scale * panel.figure.applyAsDouble(to));
        }
        double end = panel.figure.applyAsDouble(samples.get(samples.size() - 1));
        svg.text("", LEFT + width + 10, bottom - scale * end + 5, Table.number(end));
    }
}
