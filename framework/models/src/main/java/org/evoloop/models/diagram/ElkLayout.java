package org.evoloop.models.diagram;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.eclipse.elk.alg.layered.options.CycleBreakingStrategy;
import org.eclipse.elk.alg.layered.options.LayerConstraint;
import org.eclipse.elk.alg.layered.options.LayeredMetaDataProvider;
import org.eclipse.elk.alg.layered.options.LayeredOptions;
import org.eclipse.elk.alg.layered.options.NodePlacementStrategy;
import org.eclipse.elk.alg.layered.options.SelfLoopDistributionStrategy;
import org.eclipse.elk.alg.layered.options.SelfLoopOrderingStrategy;
import org.eclipse.elk.core.RecursiveGraphLayoutEngine;
import org.eclipse.elk.core.data.LayoutMetaDataService;
import org.eclipse.elk.core.math.ElkPadding;
import org.eclipse.elk.core.math.KVector;
import org.eclipse.elk.core.options.CoreOptions;
import org.eclipse.elk.core.options.Direction;
import org.eclipse.elk.core.options.EdgeLabelPlacement;
import org.eclipse.elk.core.options.EdgeRouting;
import org.eclipse.elk.core.options.HierarchyHandling;
import org.eclipse.elk.core.options.NodeLabelPlacement;
import org.eclipse.elk.core.options.SizeConstraint;
import org.eclipse.elk.core.util.BasicProgressMonitor;
import org.eclipse.elk.graph.ElkConnectableShape;
import org.eclipse.elk.graph.ElkEdge;
import org.eclipse.elk.graph.ElkEdgeSection;
import org.eclipse.elk.graph.ElkLabel;
import org.eclipse.elk.graph.ElkNode;
import org.eclipse.elk.graph.util.ElkGraphUtil;
import org.evoloop.models.diagram.Diagram.Edge;
import org.evoloop.models.diagram.Diagram.Node;
import org.evoloop.models.diagram.Diagram.Shape;
import org.evoloop.models.diagram.Layout.Box;
import org.evoloop.models.diagram.Layout.Point;
import org.evoloop.models.diagram.Layout.Wire;

/**
 * Lays out a diagram with ELK's layered algorithm: most edges run in one direction, have right angles, and leave room
 * for labels.
 */
final class ElkLayout {
    /** Looks best on a screen and on a page. */
    private static final double WISHED_ASPECT = 1.5;

    private static final double MARGIN = 16;

    /** The distance between self-loops on one side of a state. */
    private static final double LOOP_GAP = 12;

    static {
        LayoutMetaDataService.getInstance().registerLayoutMetaDataProviders(new LayeredMetaDataProvider());
    }

    private final Diagram diagram;
    private final Direction direction;
    private final LayerConstraint forInitial;
    private final Map<String, ElkNode> nodes = new HashMap<>();
    private final Map<ElkNode, Node> drawn = new LinkedHashMap<>();
    private final Map<ElkEdge, Edge> edges = new LinkedHashMap<>();

    private ElkLayout(Diagram diagram, Direction direction, LayerConstraint forInitial) {
        this.diagram = diagram;
        this.direction = direction;
        this.forInitial = forInitial;
    }

    /**
     * The better of two layouts, left to right and top to bottom. With nested states only left to right, where no edge
     * crosses the upper compartment of a frame.
     */
    static Layout of(Diagram diagram) {
        boolean flat = diagram.nodes().stream().allMatch(node -> node.children().isEmpty());
        return (flat ? Stream.of(Direction.RIGHT, Direction.DOWN) : Stream.of(Direction.RIGHT))
                .map(direction -> arrange(diagram, direction))
                .min(Comparator.comparingDouble(ElkLayout::badness))
                .orElseThrow();
    }

    /** The layout in one direction, so that a picture does not turn while its machine is edited. */
    static Layout of(Diagram diagram, boolean down) {
        return arrange(diagram, down ? Direction.DOWN : Direction.RIGHT);
    }

    /**
     * ELK fails on some nested cyclic graphs whose initial nodes must come first. Those are laid out without that
     * constraint.
     */
    private static Layout arrange(Diagram diagram, Direction direction) {
        try {
            return new ElkLayout(diagram, direction, LayerConstraint.FIRST).arrange();
        } catch (IndexOutOfBoundsException tooMuch) {
            return new ElkLayout(diagram, direction, LayerConstraint.NONE).arrange();
        }
    }

    private static double badness(Layout layout) {
        return badness(layout.width(), layout.height());
    }

    /** Lower is better: small, and close to the shape of a page. */
    static double badness(double width, double height) {
        return width * height * (1 + Math.abs(Math.log(width / height / WISHED_ASPECT)));
    }

    private Layout arrange() {
        ElkNode root = ElkGraphUtil.createGraph();
        configure(root);
        root.setProperty(CoreOptions.PADDING, new ElkPadding(MARGIN));
        diagram.nodes().forEach(node -> add(root, node));
        diagram.edges().forEach(this::add);
        new RecursiveGraphLayoutEngine().layout(root, new BasicProgressMonitor());
        List<Box> boxes = new ArrayList<>();
        drawn.forEach((placed, node) ->
                boxes.add(new Box(node, absoluteX(placed), absoluteY(placed), placed.getWidth(), placed.getHeight())));
        List<Wire> wires = new ArrayList<>();
        edges.forEach((placed, edge) -> wires.add(wire(placed, edge)));
        return new Layout(root.getWidth(), root.getHeight(), boxes, wires);
    }

    private void configure(ElkNode graph) {
        graph.setProperty(CoreOptions.ALGORITHM, LayeredOptions.ALGORITHM_ID);
        graph.setProperty(CoreOptions.HIERARCHY_HANDLING, HierarchyHandling.INCLUDE_CHILDREN);
        graph.setProperty(CoreOptions.DIRECTION, direction);
        graph.setProperty(CoreOptions.EDGE_ROUTING, EdgeRouting.ORTHOGONAL);
        graph.setProperty(CoreOptions.RANDOM_SEED, 1);
        graph.setProperty(LayeredOptions.CYCLE_BREAKING_STRATEGY, CycleBreakingStrategy.DEPTH_FIRST);
        graph.setProperty(LayeredOptions.NODE_PLACEMENT_STRATEGY, NodePlacementStrategy.NETWORK_SIMPLEX);
        graph.setProperty(LayeredOptions.SPACING_NODE_NODE, 36.0);
        graph.setProperty(LayeredOptions.SPACING_NODE_NODE_BETWEEN_LAYERS, 40.0);
        graph.setProperty(LayeredOptions.SPACING_EDGE_NODE, 18.0);
        graph.setProperty(LayeredOptions.SPACING_EDGE_NODE_BETWEEN_LAYERS, 18.0);
        graph.setProperty(LayeredOptions.SPACING_EDGE_EDGE, 14.0);
        graph.setProperty(LayeredOptions.SPACING_EDGE_EDGE_BETWEEN_LAYERS, 14.0);
        graph.setProperty(LayeredOptions.SPACING_PORT_PORT, 12.0);
        graph.setProperty(LayeredOptions.SPACING_EDGE_LABEL, 4.0);
        graph.setProperty(LayeredOptions.SPACING_LABEL_LABEL, 8.0);
        graph.setProperty(LayeredOptions.SPACING_NODE_SELF_LOOP, 18.0);
    }

    private void add(ElkNode parent, Node node) {
        ElkNode placed = ElkGraphUtil.createNode(parent);
        nodes.put(node.key(), placed);
        drawn.put(placed, node);
        if (node.shape() == Shape.STATE) {
            placed.setProperty(CoreOptions.NODE_SIZE_CONSTRAINTS, SizeConstraint.minimumSizeWithPorts());
            placed.setProperty(
                    CoreOptions.NODE_SIZE_MINIMUM,
                    new KVector(
                            Math.max(NodeSize.textWidth(node), roomForLoops(node, Direction.RIGHT)),
                            Math.max(NodeSize.textHeight(node), roomForLoops(node, Direction.DOWN))));
        } else if (node.shape() == Shape.BAR) {
            double thick = NodeSize.diameter(Shape.BAR);
            boolean upright = direction == Direction.RIGHT;
            placed.setDimensions(upright ? thick : 10 * thick, upright ? 10 * thick : thick);
        } else {
            placed.setDimensions(NodeSize.diameter(node.shape()), NodeSize.diameter(node.shape()));
        }
        placed.setProperty(
                LayeredOptions.EDGE_ROUTING_SELF_LOOP_DISTRIBUTION, SelfLoopDistributionStrategy.NORTH_SOUTH);
        placed.setProperty(LayeredOptions.EDGE_ROUTING_SELF_LOOP_ORDERING, SelfLoopOrderingStrategy.SEQUENCED);
        if (node.shape() == Shape.INITIAL) {
            placed.setProperty(LayeredOptions.LAYERING_LAYER_CONSTRAINT, forInitial);
        }
        if (hasNameBelow(node)) {
            List<String> name = NodeSize.name(node);
            ElkLabel label = ElkGraphUtil.createLabel(node.name(), placed);
            label.setDimensions(TextSize.width(name, false), TextSize.height(name));
            placed.setProperty(CoreOptions.NODE_LABELS_PLACEMENT, NodeLabelPlacement.outsideBottomCenter());
        }
        if (!node.children().isEmpty()) {
            addChildren(placed, node);
        }
    }

    /** The length needed on the two sides that carry the node's self-loops in this direction. */
    private double roomForLoops(Node node, Direction along) {
        List<List<String>> labels = diagram.edges().stream()
                .filter(edge ->
                        edge.source().equals(node.key()) && edge.target().equals(node.key()))
                .map(edge -> NodeSize.label(edge.label()))
                .toList();
        if (along != direction || labels.size() < 3) {
            return 0;
        }
        double longest = labels.stream()
                .mapToDouble(label -> along == Direction.RIGHT ? TextSize.width(label, false) : TextSize.height(label))
                .max()
                .orElse(0);
        int onOneSide = (labels.size() + 1) / 2;
        return onOneSide * (longest + LOOP_GAP);
    }

    /**
     * Whether its name is drawn below it because there is no room inside. The name of an initial pseudostate is not
     * drawn.
     */
    static boolean hasNameBelow(Node node) {
        return switch (node.shape()) {
            case STATE, REGION, INITIAL -> false;
            default -> !node.name().isEmpty();
        };
    }

    private void addChildren(ElkNode placed, Node node) {
        configure(placed);
        boolean orthogonal = node.children().stream().anyMatch(child -> child.shape() == Shape.REGION);
        if (node.shape() == Shape.STATE) {
            double side = orthogonal ? 2 : MARGIN;
            placed.setProperty(CoreOptions.PADDING, new ElkPadding(NodeSize.textHeight(node) + side, side, side, side));
        } else {
            placed.setProperty(CoreOptions.PADDING, new ElkPadding(MARGIN));
        }
        node.children().forEach(child -> add(placed, child));
    }

    private void add(Edge edge) {
        ElkConnectableShape source = known(edge.source());
        ElkConnectableShape target = known(edge.target());
        ElkEdge placed = ElkGraphUtil.createSimpleEdge(source, target);
        edges.put(placed, edge);
        List<String> lines = NodeSize.label(edge.label());
        if (!lines.isEmpty()) {
            ElkLabel label = ElkGraphUtil.createLabel(edge.label(), placed);
            label.setDimensions(TextSize.width(lines, false), TextSize.height(lines));
            label.setProperty(CoreOptions.EDGE_LABELS_PLACEMENT, EdgeLabelPlacement.CENTER);
        }
    }

    private ElkNode known(String key) {
        ElkNode node = nodes.get(key);
        if (node == null) {
            throw new IllegalArgumentException("an edge refers to " + key + ", which is no node of the diagram");
        }
        return node;
    }

    private Wire wire(ElkEdge placed, Edge edge) {
        ElkNode origin = placed.getContainingNode();
        double x = absoluteX(origin);
        double y = absoluteY(origin);
        List<Point> points = new ArrayList<>();
        for (ElkEdgeSection section : placed.getSections()) {
            points.add(new Point(x + section.getStartX(), y + section.getStartY()));
            section.getBendPoints().forEach(bend -> points.add(new Point(x + bend.getX(), y + bend.getY())));
            points.add(new Point(x + section.getEndX(), y + section.getEndY()));
        }
        Point at = placed.getLabels().stream()
                .findFirst()
                .map(label -> new Point(x + label.getX(), y + label.getY()))
                .orElse(new Point(x, y));
        return new Wire(edge, points, NodeSize.label(edge.label()), at);
    }

    private static double absoluteX(ElkNode node) {
        ElkNode parent = node.getParent();
        return parent == null ? 0 : node.getX() + absoluteX(parent);
    }

    private static double absoluteY(ElkNode node) {
        ElkNode parent = node.getParent();
        return parent == null ? 0 : node.getY() + absoluteY(parent);
    }
}
