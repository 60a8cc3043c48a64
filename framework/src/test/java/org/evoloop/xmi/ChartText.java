package org.evoloop.xmi;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.evoloop.statechart.Arc;
import org.evoloop.statechart.Region;
import org.evoloop.statechart.Statechart;
import org.evoloop.statechart.Vertex;
import org.evoloop.statechart.Vertex.ChartState;
import org.evoloop.statemachine.ModelException;

/** A chart as lines that a test can compare, one a vertex and one a transition, two spaces a level. */
public final class ChartText {
    private ChartText() {}

    /** The machines of a document. */
    public static List<XmiMachine> machines(String document) {
        return XmiFile.read("F.xml", new ByteArrayInputStream(document.getBytes(StandardCharsets.UTF_8)))
                .machines();
    }

    /** The document's first machine. */
    public static List<String> of(String document) {
        return of(machines(document).get(0).statechart());
    }

    public static List<String> of(Statechart chart) {
        List<String> lines = new ArrayList<>();
        chart.regions().forEach(region -> region(region, "", lines));
        return lines;
    }

    /** What is said of the document's first machine; empty if it is read. */
    public static String refusal(String document) {
        try {
            machines(document).get(0).statechart();
            return "";
        } catch (ModelException refused) {
            return String.valueOf(refused.getMessage());
        }
    }

    private static void region(Region region, String indent, List<String> lines) {
        if (!region.name().isEmpty()) {
            lines.add(indent + "region " + region.name());
        }
        region.vertices().forEach(vertex -> vertex(vertex, indent, lines));
        region.arcs().forEach(arc -> lines.add(indent + arc(arc)));
    }

    private static void vertex(Vertex vertex, String indent, List<String> lines) {
        if (vertex instanceof ChartState state) {
            lines.add(indent + "state " + state.key() + " " + state.name() + words(state));
            state.connections().forEach(point -> vertex(point, indent + "  ", lines));
            state.internal().forEach(arc -> lines.add(indent + "  " + arc(arc)));
            state.regions().forEach(region -> region(region, indent + "  ", lines));
        } else {
            String kind = vertex instanceof Vertex.Pseudostate pseudostate
                    ? pseudostate.kind().name()
                    : "FINAL";
            lines.add((indent + kind + " " + vertex.key() + " " + vertex.name()).stripTrailing());
        }
    }

    private static String words(ChartState state) {
        return words("entry", state.entry())
                + words("exit", state.exit())
                + words("do", state.doActivities())
                + words("defer", state.deferred());
    }

    private static String words(String role, List<String> texts) {
        return texts.isEmpty() ? "" : " " + role + texts;
    }

    private static String arc(Arc arc) {
        String label = String.join(
                " ",
                Stream.of(
                                String.join(", ", arc.triggers()),
                                arc.guard().isEmpty() ? "" : "[" + arc.guard() + "]",
                                arc.effects().isEmpty() ? "" : "/ " + String.join("; ", arc.effects()),
                                arc.kind() == Arc.Kind.EXTERNAL
                                        ? ""
                                        : arc.kind().name())
                        .filter(text -> !text.isEmpty())
                        .toList());
        return arc.source() + " -> " + arc.target() + (label.isEmpty() ? "" : " : " + label);
    }
}
