package org.evoloop.models.diagram;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import org.evoloop.models.chart.ArcLabel;
import org.evoloop.models.chart.StateLabel;
import org.evoloop.models.diagram.Diagram.Edge;
import org.evoloop.models.diagram.Diagram.Node;
import org.evoloop.models.diagram.Diagram.Shape;
import org.evoloop.models.diagram.Diagram.Tone;
import org.evoloop.statechart.Arc;
import org.evoloop.statechart.Region;
import org.evoloop.statechart.Statechart;
import org.evoloop.statechart.Vertex;
import org.evoloop.statechart.Vertex.ChartState;
import org.evoloop.statechart.Vertex.Pseudostate;

/** Turns a chart into a diagram. */
public final class ChartDiagram {
    private final Function<Vertex, Tone> vertexTone;
    private final Function<Arc, Tone> arcTone;
    private final Data data;
    private final List<Edge> edges = new ArrayList<>();
    private int regions;

    /** What a program wants to know of the elements. */
    public interface Data {
        /** There is nothing. */
        Data NONE = new Data() {
            @Override
            public Map<String, String> of(Vertex vertex) {
                return Map.of();
            }

            @Override
            public Map<String, String> of(Arc arc) {
                return Map.of();
            }
        };

        /** Of a vertex. */
        Map<String, String> of(Vertex vertex);

        /** Of a transition. */
        Map<String, String> of(Arc arc);
    }

    private ChartDiagram(Function<Vertex, Tone> vertexTone, Function<Arc, Tone> arcTone, Data data) {
        this.vertexTone = vertexTone;
        this.arcTone = arcTone;
        this.data = data;
    }

    /** The diagram of {@code chart} without tones. */
    public static Diagram of(Statechart chart) {
        return of(chart, vertex -> Tone.PLAIN, arc -> Tone.PLAIN);
    }

    /** The diagram of {@code chart} with a tone for each element. */
    public static Diagram of(Statechart chart, Function<Vertex, Tone> vertexTone, Function<Arc, Tone> arcTone) {
        return of(chart, vertexTone, arcTone, Data.NONE);
    }

    /** The diagram of {@code chart} with a tone for each element, and what a program wants to know of it. */
    public static Diagram of(
            Statechart chart, Function<Vertex, Tone> vertexTone, Function<Arc, Tone> arcTone, Data data) {
        ChartDiagram builder = new ChartDiagram(vertexTone, arcTone, data);
        List<Node> nodes = chart.regions().size() == 1
                ? builder.nodes(chart.regions().get(0))
                : chart.regions().stream().map(builder::region).toList();
        return new Diagram(chart.name(), nodes, builder.edges);
    }

    private List<Node> nodes(Region region) {
        region.arcs().stream().filter(arc -> arc.kind() != Arc.Kind.INTERNAL).forEach(this::edge);
        return region.vertices().stream().map(this::node).toList();
    }

    private Node region(Region region) {
        return new Node(
                "region " + ++regions, Shape.REGION, region.name(), List.of(), nodes(region), Tone.PLAIN, Map.of());
    }

    private void edge(Arc arc) {
        edges.add(new Edge(arc.source(), arc.target(), ArcLabel.of(arc), arcTone.apply(arc), data.of(arc)));
    }

    private Node node(Vertex vertex) {
        if (vertex instanceof ChartState state) {
            return state(state);
        }
        Shape shape = vertex instanceof Pseudostate pseudostate ? shape(pseudostate.kind()) : Shape.FINAL;
        return new Node(
                vertex.key(),
                shape,
                StateLabel.beside(vertex),
                List.of(),
                List.of(),
                vertexTone.apply(vertex),
                data.of(vertex));
    }

    private Node state(ChartState state) {
        List<Node> children = new ArrayList<>();
        state.connections().forEach(point -> children.add(node(point)));
        if (state.regions().size() == 1) {
            children.addAll(nodes(state.regions().get(0)));
        } else {
            state.regions().forEach(region -> children.add(region(region)));
        }
        return new Node(
                state.key(),
                Shape.STATE,
                state.name(),
                StateLabel.belowName(state),
                children,
                vertexTone.apply(state),
                data.of(state));
    }

    private static Shape shape(Vertex.Kind kind) {
        return switch (kind) {
            case INITIAL -> Shape.INITIAL;
            case SHALLOW_HISTORY -> Shape.SHALLOW_HISTORY;
            case DEEP_HISTORY -> Shape.DEEP_HISTORY;
            case JOIN, FORK -> Shape.BAR;
            case JUNCTION -> Shape.JUNCTION;
            case CHOICE -> Shape.CHOICE;
            case ENTRY_POINT -> Shape.ENTRY_POINT;
            case EXIT_POINT -> Shape.EXIT_POINT;
            case TERMINATE -> Shape.TERMINATE;
        };
    }
}
