package org.evoloop.models.diagram;

import java.util.EnumSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.evoloop.models.diagram.Diagram.Tone;
import org.evoloop.models.diagram.Layout.Box;
import org.evoloop.models.diagram.Layout.Point;
import org.evoloop.models.diagram.Layout.Wire;

/**
 * Writes diagrams as one SVG picture: a frame each, and a legend if a part has a tone of its own. The text is the same
 * for the same diagrams, on every machine.
 */
public final class SvgWriter {
    private static final double GAP = 16;
    private static final double HEADING = 32;
    private static final double LEGEND_LINE = 24;
    private static final double CORNER = 7;

    private static final String STYLE = """
            <style>
            .box { stroke: #333; stroke-width: 1.5 }
            .line { fill: none; stroke: #333; stroke-width: 1.5; stroke-linejoin: round }
            .g .frame, .state .frame, .pseudostate .hollow { fill: #fff }
            .separator { stroke-dasharray: 9 6 }
            text { fill: #333 }
            .name { text-anchor: middle; font-weight: bold }
            .middle { text-anchor: middle }
            .heading { font-size: 17px; font-weight: bold }
            .label { paint-order: stroke; stroke: #fff; stroke-width: 4px; stroke-linejoin: round }
            """;

    private final Svg svg = new Svg();

    private SvgWriter() {}

    /** The picture of {@code diagrams}, one beside or above the other. */
    public static String write(String title, List<Diagram> diagrams) {
        return new SvgWriter().picture(title, diagrams);
    }

    private String picture(String title, List<Diagram> diagrams) {
        List<Layout> layouts = diagrams.stream().map(ElkLayout::of).toList();
        Set<Tone> tones = tones(diagrams);
        double legend = tones.equals(EnumSet.of(Tone.PLAIN)) ? 0 : tones.size() * LEGEND_LINE + GAP;
        boolean across = isBetterAcross(layouts);
        double width =
                extent(layouts.stream().mapToDouble(SvgWriter::frameWidth).toArray(), across);
        double height =
                extent(layouts.stream().mapToDouble(SvgWriter::frameHeight).toArray(), !across) + legend;
        width = Math.max(width, legend == 0 ? 0 : 330);
        svg.open(
                "svg",
                "xmlns",
                "http://www.w3.org/2000/svg",
                "viewBox",
                "0 0 " + NodePainter.pair(width, height),
                "width",
                width,
                "height",
                height,
                "font-family",
                "DejaVu Sans, Verdana, Arial, sans-serif",
                "font-size",
                TextSize.FONT_SIZE);
        svg.text("title", title).raw(STYLE);
        tones.forEach(tone -> svg.raw(Palette.of(tone).css()));
        svg.raw("</style>\n<defs>\n");
        tones.forEach(tone -> svg.raw(Palette.of(tone).marker()));
        svg.raw("</defs>\n").empty("rect", "width", width, "height", height, "fill", "#fff");
        double x = GAP;
        double y = GAP;
        for (int i = 0; i < layouts.size(); i++) {
            machine(diagrams.get(i), layouts.get(i), x, y);
            x += across ? frameWidth(layouts.get(i)) + GAP : 0;
            y += across ? 0 : frameHeight(layouts.get(i)) + GAP;
        }
        if (legend > 0) {
            legend(tones, height - legend);
        }
        return svg.close("svg").toString();
    }

    private static Set<Tone> tones(List<Diagram> diagrams) {
        Set<Tone> tones = EnumSet.of(Tone.PLAIN);
        for (Diagram diagram : diagrams) {
            diagram.nodes().forEach(node -> collect(node, tones));
            diagram.edges().forEach(edge -> tones.add(edge.tone()));
        }
        return tones;
    }

    private static void collect(Diagram.Node node, Set<Tone> tones) {
        tones.add(node.tone());
        node.children().forEach(child -> collect(child, tones));
    }

    private static double frameWidth(Layout layout) {
        return Math.max(layout.width(), 120);
    }

    private static double frameHeight(Layout layout) {
        return layout.height() + HEADING;
    }

    private static boolean isBetterAcross(List<Layout> layouts) {
        double sum = layouts.stream().mapToDouble(SvgWriter::frameWidth).sum();
        double highest =
                layouts.stream().mapToDouble(SvgWriter::frameHeight).max().orElse(1);
        return sum / highest <= 2;
    }

    /** Of all frames with the gaps around them, side by side or over each other. */
    private static double extent(double[] frames, boolean sideBySide) {
        double all = 0;
        for (double frame : frames) {
            all = sideBySide ? all + frame + GAP : Math.max(all, frame + GAP);
        }
        return all + GAP;
    }

    private void machine(Diagram diagram, Layout layout, double x, double y) {
        svg.open("g", "class", "machine", "transform", "translate(" + NodePainter.pair(x, y) + ")");
        svg.empty(
                "rect",
                "width",
                frameWidth(layout),
                "height",
                frameHeight(layout),
                "rx",
                4.0,
                "fill",
                "none",
                "stroke",
                "#bbb");
        svg.text("text", diagram.title(), "class", "heading", "x", 12.0, "y", 23.0);
        svg.open("g", "transform", "translate(" + NodePainter.pair(0, HEADING) + ")");
        Map<String, Box> boxes = new HashMap<>();
        layout.boxes().forEach(box -> boxes.put(box.node().key(), box));
        NodePainter painter = new NodePainter(svg, boxes);
        layout.boxes().forEach(painter::paint);
        layout.wires().forEach(wire -> way(wire, boxes));
        layout.wires().forEach(this::label);
        svg.close("g").close("g");
    }

    private void way(Wire wire, Map<String, Box> boxes) {
        Box source = boxes.get(wire.edge().source());
        Box target = boxes.get(wire.edge().target());
        if (source == null || target == null || wire.points().size() < 2) {
            return;
        }
        svg.open("g", "class", "transition " + Palette.of(wire.edge().tone()).cssClass());
        svg.empty("path", "class", "line way", "d", path(Ends.onOutlines(wire.points(), source, target)));
        svg.close("g");
    }

    /** Through {@code points}, with round corners. */
    private static String path(List<Point> points) {
        Point at = points.get(0);
        StringBuilder path = new StringBuilder("M" + NodePainter.pair(at.x(), at.y()));
        for (int i = 1; i < points.size() - 1; i++) {
            Point corner = points.get(i);
            Point before = towards(corner, points.get(i - 1));
            Point after = towards(corner, points.get(i + 1));
            path.append(" L").append(NodePainter.pair(before.x(), before.y()));
            path.append(" Q").append(NodePainter.pair(corner.x(), corner.y()));
            path.append(' ').append(NodePainter.pair(after.x(), after.y()));
        }
        Point end = points.get(points.size() - 1);
        return path.append(" L").append(NodePainter.pair(end.x(), end.y())).toString();
    }

    /** A little from {@code corner} towards {@code next}, at most half the way. */
    private static Point towards(Point corner, Point next) {
        double length = Math.hypot(next.x() - corner.x(), next.y() - corner.y());
        double part = length == 0 ? 0 : Math.min(CORNER, length / 2) / length;
        return new Point(corner.x() + (next.x() - corner.x()) * part, corner.y() + (next.y() - corner.y()) * part);
    }

    private void label(Wire wire) {
        double baseline = wire.at().y() + TextSize.LINE_HEIGHT * 0.75;
        if (wire.label().isEmpty()) {
            return;
        }
        svg.open("g", "class", "event " + Palette.of(wire.edge().tone()).cssClass());
        for (String line : wire.label()) {
            svg.text("text", line, "class", "label", "x", wire.at().x(), "y", baseline);
            baseline += TextSize.LINE_HEIGHT;
        }
        svg.close("g");
    }

    private void legend(Set<Tone> tones, double top) {
        double y = top + LEGEND_LINE / 2;
        for (Tone tone : tones) {
            Palette palette = Palette.of(tone);
            svg.open("g", "class", "legend " + palette.cssClass());
            svg.empty(
                    "path",
                    "class",
                    "line way",
                    "d",
                    "M" + NodePainter.pair(GAP, y) + " L" + NodePainter.pair(GAP + 46, y));
            svg.text("text", palette.meaning(), "x", GAP + 58, "y", y + 4.5);
            svg.close("g");
            y += LEGEND_LINE;
        }
    }
}
