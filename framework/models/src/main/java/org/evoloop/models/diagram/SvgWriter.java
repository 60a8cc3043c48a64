package org.evoloop.models.diagram;

import java.util.EnumSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import org.evoloop.models.diagram.Diagram.Tone;
import org.evoloop.models.diagram.Layout.Box;
import org.evoloop.models.diagram.Layout.Point;
import org.evoloop.models.diagram.Layout.Wire;
import org.evoloop.svg.Svg;

/**
 * Writes diagrams as one SVG picture: a frame for each, and a legend if an element has a special tone. Equal diagrams
 * give the same text on every machine.
 */
public final class SvgWriter {
    private static final double GAP = Shelves.GAP;
    private static final double LEGEND_LINE = 24;
    private static final double LEGEND_WIDTH = 330;
    private static final double CORNER = 7;

    private static final String STYLE = """
            .border { fill: none; stroke: #bbb }
            .line { fill: none; stroke-linejoin: round }
            .separator { stroke-dasharray: 9 6 }
            .name { text-anchor: middle; font-weight: bold }
            .middle { text-anchor: middle }
            .heading { font-size: 17px; font-weight: bold; fill: #333 }
            .label { paint-order: stroke; stroke: #fff; stroke-width: 4px; stroke-linejoin: round }
            """;

    /** Comes after the colours in the stylesheet, and so overrides them. */
    private static final String FRAME_STYLE = ".state .frame, .pseudostate .hollow { fill: #fff }\n";

    private final Svg svg;

    /** Whether programs show the picture in their own colours, and find its elements by their data. */
    private final boolean plain;

    private SvgWriter(Svg svg, boolean plain) {
        this.svg = svg;
        this.plain = plain;
    }

    /**
     * A picture of one machine for a page, which has the colours: without heading, frame, legend and style. Each element
     * has what the diagram says of it as attributes {@code data-...}.
     *
     * @param name of the picture, unique on the page; letters only
     * @param layouts keeps what can be used again
     */
    public static String plain(String name, Diagram diagram, boolean down, Layouts layouts) {
        Layout layout = layouts.of(diagram, down);
        String marker =
                "<marker id=\"arrow-" + name + "\" viewBox=\"0 0 10 10\" refX=\"9\" refY=\"5\" markerWidth=\"10\""
                        + " markerHeight=\"10\" markerUnits=\"userSpaceOnUse\" orient=\"auto\"><path class=\"arrowhead\""
                        + " d=\"M0 1 L9 5 L0 9\" fill=\"none\" stroke=\"context-stroke\"/></marker>\n";
        SvgWriter writer = new SvgWriter(
                Svg.unstyled(diagram.title(), layout.width(), layout.height(), TextSize.FONT_SIZE, marker), true);
        writer.svg.group("machine", Map.of("marker", name));
        writer.drawing(layout, "url(#arrow-" + name + ")");
        writer.svg.endGroup();
        return writer.svg.toString();
    }

    /** A picture of {@code diagrams}. */
    public static String write(String title, List<Diagram> diagrams) {
        return write(title, diagrams, Table.NONE);
    }

    /** A picture with a table below. */
    public static String write(String title, List<Diagram> diagrams, Table table) {
        return write(title, diagrams, table, List.of());
    }

    /** A picture with timing diagrams below. */
    public static String write(String title, List<Diagram> diagrams, List<Timing> timings) {
        return write(title, diagrams, Table.NONE, timings);
    }

    private static String write(String title, List<Diagram> diagrams, Table table, List<Timing> timings) {
        List<Layout> layouts = diagrams.stream().map(ElkLayout::of).toList();
        Shelves shelves = Shelves.of(layouts);
        Set<Tone> tones = tones(diagrams);
        table.rows().forEach(row -> tones.add(row.tone()));
        Set<Tone> explained = explained(tones);
        double legend = explained.isEmpty() ? 0 : explained.size() * LEGEND_LINE + GAP;
        TablePainter rows = new TablePainter(table);
        double below = table.caption().isEmpty() ? 0 : rows.height() + GAP;
        double drawn = Math.max(shelves.width(), below == 0 ? 0 : rows.width() + 2 * GAP);
        List<TimingPainter> painters = timings.stream().map(TimingPainter::new).toList();
        double timed = 0;
        for (TimingPainter painter : painters) {
            drawn = Math.max(drawn, painter.width() + 2 * GAP);
            timed += painter.height() + GAP;
        }
        double width = legend == 0 ? drawn : Math.max(drawn, LEGEND_WIDTH);
        SvgWriter writer = new SvgWriter(
                new Svg(
                        title,
                        width,
                        shelves.height() + legend + below + timed,
                        TextSize.FONT_SIZE,
                        style(tones)
                                + (below == 0 ? "" : TablePainter.STYLE)
                                + (painters.isEmpty() ? "" : TimingPainter.STYLE),
                        markers(tones)),
                false);
        for (int i = 0; i < layouts.size(); i++) {
            writer.machine(diagrams.get(i), layouts.get(i), shelves.places().get(i));
        }
        if (legend > 0) {
            writer.legend(explained, shelves.height());
        }
        if (below > 0) {
            writer.svg.group("table", GAP, shelves.height() + legend);
            rows.paint(writer.svg);
            writer.svg.endGroup();
        }
        double top = shelves.height() + legend + below;
        for (TimingPainter painter : painters) {
            writer.svg.group("timing", GAP, top);
            painter.paint(writer.svg);
            writer.svg.endGroup();
            top += painter.height() + GAP;
        }
        return writer.svg.toString();
    }

    private static String style(Set<Tone> tones) {
        return tones.stream().map(tone -> Palette.of(tone).css()).collect(Collectors.joining("", STYLE, FRAME_STYLE));
    }

    private static String markers(Set<Tone> tones) {
        return tones.stream().map(tone -> Palette.of(tone).marker()).collect(Collectors.joining());
    }

    private static Set<Tone> tones(List<Diagram> diagrams) {
        Set<Tone> tones = EnumSet.of(Tone.PLAIN);
        for (Diagram diagram : diagrams) {
            diagram.nodes().forEach(node -> collect(node, tones));
            diagram.edges().forEach(edge -> tones.add(edge.tone()));
        }
        return tones;
    }

    /** The tones in the legend. Plain is explained only beside tones for added, removed or changed elements. */
    private static Set<Tone> explained(Set<Tone> tones) {
        Set<Tone> explained = EnumSet.copyOf(tones);
        if (EnumSet.of(Tone.PLAIN, Tone.MARKED, Tone.OTHERWISE, Tone.BROKEN).containsAll(tones)) {
            explained.remove(Tone.PLAIN);
        }
        return explained;
    }

    private static void collect(Diagram.Node node, Set<Tone> tones) {
        tones.add(node.tone());
        node.children().forEach(child -> collect(child, tones));
    }

    private void machine(Diagram diagram, Layout layout, Point at) {
        svg.group("machine", at.x(), at.y());
        svg.rectangle("border", 0, 0, Shelves.frameWidth(layout), Shelves.frameHeight(layout), 4);
        svg.text("heading", 12, 23, diagram.title());
        svg.group("drawing", 0, Shelves.HEADING);
        drawing(layout, "");
        svg.endGroup().endGroup();
    }

    /** @param arrow the end of each transition's line; empty if the style says so */
    private void drawing(Layout layout, String arrow) {
        Map<String, Box> boxes = new HashMap<>();
        layout.boxes().forEach(box -> boxes.put(box.node().key(), box));
        NodePainter painter = new NodePainter(svg, boxes, plain);
        layout.boxes().forEach(painter::paint);
        layout.wires().forEach(wire -> way(wire, boxes, arrow));
        layout.wires().forEach(this::label);
    }

    private Map<String, String> data(Map<String, String> known) {
        return plain ? known : Map.of();
    }

    private void way(Wire wire, Map<String, Box> boxes, String arrow) {
        Box source = boxes.get(wire.edge().source());
        Box target = boxes.get(wire.edge().target());
        if (source != null && target != null) {
            svg.group(
                    "transition " + Palette.of(wire.edge().tone()).cssClass(),
                    data(wire.edge().data()));
            String path = path(Ends.onOutlines(wire.points(), source, target));
            svg.path("line way", path, arrow).endGroup();
        }
    }

    /** A path through {@code points}, with round corners. */
    private static String path(List<Point> points) {
        Point start = points.get(0);
        StringBuilder path = new StringBuilder("M" + Svg.pair(start.x(), start.y()));
        for (int i = 1; i < points.size() - 1; i++) {
            Point corner = points.get(i);
            Point before = towards(corner, points.get(i - 1));
            Point after = towards(corner, points.get(i + 1));
            path.append(" L").append(Svg.pair(before.x(), before.y()));
            path.append(" Q").append(Svg.pair(corner.x(), corner.y()));
            path.append(' ').append(Svg.pair(after.x(), after.y()));
        }
        Point end = points.get(points.size() - 1);
        return path.append(" L").append(Svg.pair(end.x(), end.y())).toString();
    }

    /** A point near {@code corner}, towards {@code next}, at most half-way. */
    private static Point towards(Point corner, Point next) {
        double length = Math.hypot(next.x() - corner.x(), next.y() - corner.y());
        double part = length == 0 ? 0 : Math.min(CORNER, length / 2) / length;
        return new Point(corner.x() + (next.x() - corner.x()) * part, corner.y() + (next.y() - corner.y()) * part);
    }

    private void label(Wire wire) {
        if (wire.label().isEmpty()) {
            return;
        }
        svg.group(
                "event " + Palette.of(wire.edge().tone()).cssClass(),
                data(wire.edge().data()));
        double baseline = wire.at().y() + TextSize.ASCENT;
        for (String line : wire.label()) {
            svg.text("label", wire.at().x(), baseline, line);
            baseline += TextSize.LINE_HEIGHT;
        }
        svg.endGroup();
    }

    private void legend(Set<Tone> tones, double top) {
        double y = top + LEGEND_LINE / 2;
        for (Tone tone : tones) {
            Palette palette = Palette.of(tone);
            svg.group("legend " + palette.cssClass());
            svg.line("line way", GAP, y, GAP + 46, y);
            svg.text("meaning", GAP + 58, y + 4.5, palette.meaning()).endGroup();
            y += LEGEND_LINE;
        }
    }
}
