package org.evoloop.xmi.scxml;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.evoloop.statechart.Arc;
import org.evoloop.statechart.Place;
import org.evoloop.statechart.Region;
import org.evoloop.statechart.Statechart;
import org.evoloop.statechart.Vertex;
import org.evoloop.statechart.Vertex.ChartState;
import org.evoloop.statechart.Vertex.FinalState;
import org.evoloop.statechart.Vertex.Kind;
import org.evoloop.statechart.Vertex.Pseudostate;
import org.evoloop.xmi.dialect.Problems;
import org.evoloop.xmi.dialect.XmlNode;
import org.jspecify.annotations.Nullable;

/** Turns a document into a chart. */
final class ScxmlChartReader {
    private final ScxmlTree tree;
    private final ScxmlArcs arcs;
    private final Problems problems;

    ScxmlChartReader(ScxmlTree tree, Problems problems) {
        this.tree = tree;
        this.arcs = new ScxmlArcs(tree, problems);
        this.problems = problems;
    }

    Statechart read(String title) {
        ScxmlDocument document = tree.document();
        ScxmlVocabulary.check(document, problems);
        List<String> beginning = new ArrayList<>();
        beginning(null, beginning);
        if (tree.vertices(null).isEmpty()) {
            problems.add(document.line(), "scxml has no state; write one");
        }
        arcs.readAll(null);
        Region region = region(null, "", new Place("", document.line()), beginning);
        return new Statechart(title, region.place(), List.of(region), List.of());
    }

    /** What happens before the first state is entered: the data model gets its values, scripts are run. */
    private void beginning(@Nullable XmlNode container, List<String> effects) {
        for (XmlNode child : tree.children(container)) {
            if (child.name().equals("datamodel")) {
                ScxmlVocabulary.check(child, problems);
                effects.addAll(ScxmlActions.data(child));
                if (container != null && tree.document().attribute("binding").equals("late")) {
                    problems.add(child.line(), "late binding of data is not supported; use binding=\"early\"");
                }
            } else if (child.name().equals("script")) {
                effects.add(ScxmlActions.text(child));
            }
        }
        tree.vertices(container).forEach(vertex -> beginning(vertex, effects));
    }

    /** The region of everything directly in a state, or in the root for null. */
    private Region region(@Nullable XmlNode container, String name, Place place, List<String> effects) {
        String region = arcs.regionIn(container);
        List<Vertex> vertices = new ArrayList<>();
        if (!tree.vertices(container).isEmpty()) {
            vertices.add(initial(container, region, place, effects));
        }
        for (XmlNode vertex : tree.vertices(container)) {
            vertex(vertex, vertices);
        }
        vertices.addAll(arcs.forksIn(region));
        return new Region(name, place, vertices, arcs.in(region));
    }

    private Vertex initial(@Nullable XmlNode container, String region, Place place, List<String> effects) {
        String key = tree.madeUpKey();
        List<XmlNode> elements = tree.children(container).stream()
                .filter(child -> child.name().equals("initial"))
                .toList();
        List<XmlNode> transitions = elements.stream()
                .flatMap(element -> element.children("transition").stream())
                .toList();
        elements.forEach(element -> ScxmlVocabulary.check(element, problems));
        String ids = attribute(container, "initial") + " " + attribute(container, "initialstate");
        if (transitions.size() == 1 && ids.isBlank()) {
            XmlNode transition = transitions.get(0);
            List<String> all = Stream.concat(effects.stream(), ScxmlActions.in(transition).stream())
                    .toList();
            arcs.unconditional(transition, key, region, all);
        } else if (!elements.isEmpty()) {
            problems.add(
                    place.line(),
                    "initial of " + (container == null ? "scxml" : ScxmlVocabulary.label(container))
                            + " is not one transition; write one");
        } else {
            List<XmlNode> targets = ids.isBlank() ? firstState(container) : tree.targets(ids, place.line(), "initial");
            arcs.lead(key, region, targets, "", "initial", effects, place);
        }
        return new Pseudostate(key, "", place, Kind.INITIAL);
    }

    private String attribute(@Nullable XmlNode container, String name) {
        return container == null ? tree.document().attribute(name) : container.attribute(name);
    }

    private List<XmlNode> firstState(@Nullable XmlNode container) {
        return tree.vertices(container).stream()
                .filter(vertex -> !vertex.name().equals("history"))
                .limit(1)
                .toList();
    }

    private void vertex(XmlNode node, List<Vertex> vertices) {
        ScxmlVocabulary.check(node, problems);
        String key = tree.key(node);
        Place place = ScxmlTree.place(node);
        switch (node.name()) {
            case "history" ->
                vertices.add(new Pseudostate(key, node.attribute("id").strip(), place, kind(node)));
            case "final" -> end(node, vertices);
            default -> {
                if (node.attribute("final").equals("true")) {
                    end(node, vertices);
                } else {
                    vertices.add(state(node, regions(node)));
                }
            }
        }
    }

    /** A final state; one that does something on entering is a state that is completed at once. */
    private void end(XmlNode node, List<Vertex> vertices) {
        String name = node.attribute("id").strip();
        Place place = ScxmlTree.place(node);
        if (tree.isComposite(node) || !node.children("transition").isEmpty()) {
            problems.add(place.line(), ScxmlVocabulary.label(node) + " is final but goes on; let it end here");
        }
        List<String> entry = Stream.concat(
                        actions(node, "onentry").stream(),
                        node.children("donedata").stream().map(ScxmlActions::text))
                .toList();
        List<String> exit = actions(node, "onexit");
        if (entry.isEmpty() && exit.isEmpty()) {
            vertices.add(new FinalState(tree.key(node), name, place));
            return;
        }
        if (!exit.isEmpty() && tree.parent(node) != null) {
            problems.note(
                    place.line(),
                    "onexit of " + ScxmlVocabulary.label(node)
                            + " is run as soon as that is entered, not when the state"
                            + " around it is left; move it there if that matters");
        }
        FinalState end = new FinalState(tree.madeUpKey(), name, place);
        arcs.complete(node, end);
        vertices.add(new ChartState(
                tree.key(node), name, place, entry, exit, List.of(), List.of(), List.of(), List.of(), List.of()));
        vertices.add(end);
    }

    private List<Region> regions(XmlNode state) {
        if (!ScxmlTree.isParallel(state)) {
            return tree.vertices(state).isEmpty()
                    ? List.of()
                    : List.of(region(state, "", ScxmlTree.place(state), List.of()));
        }
        List<Region> regions = new ArrayList<>();
        for (XmlNode child : tree.vertices(state)) {
            if (child.name().equals("history")) {
                continue;
            }
            String initial = tree.madeUpKey();
            List<Vertex> vertices = new ArrayList<>();
            vertices.add(new Pseudostate(initial, "", ScxmlTree.place(child), Kind.INITIAL));
            vertex(child, vertices);
            vertices.addAll(arcs.forksIn(arcs.region(child)));
            histories(state, child, vertices);
            List<Arc> inRegion = new ArrayList<>();
            inRegion.add(new Arc(
                    ScxmlTree.place(child), initial, tree.key(child), List.of(), "", List.of(), Arc.Kind.EXTERNAL));
            inRegion.addAll(arcs.in(arcs.region(child)));
            regions.add(new Region(child.attribute("id").strip(), ScxmlTree.place(child), vertices, inRegion));
        }
        return regions;
    }

    /** A history of a parallel state is one of each of its regions. */
    private void histories(XmlNode parallel, XmlNode child, List<Vertex> vertices) {
        for (XmlNode vertex : tree.vertices(parallel)) {
            if (vertex.name().equals("history")) {
                String name = vertex.attribute("id").strip();
                vertices.add(
                        new Pseudostate(arcs.historyKey(vertex, child), name, ScxmlTree.place(vertex), kind(vertex)));
            }
        }
    }

    private static Kind kind(XmlNode history) {
        return history.attribute("type").equals("deep") ? Kind.DEEP_HISTORY : Kind.SHALLOW_HISTORY;
    }

    private ChartState state(XmlNode node, List<Region> regions) {
        return new ChartState(
                tree.key(node),
                name(node),
                ScxmlTree.place(node),
                actions(node, "onentry"),
                actions(node, "onexit"),
                node.children("invoke").stream().map(ScxmlActions::text).toList(),
                arcs.internal(node),
                List.of(),
                regions,
                List.of());
    }

    /** The id; without one, which SCXML allows, the line tells states apart. */
    private String name(XmlNode state) {
        String id = state.attribute("id").strip();
        if (!id.isEmpty()) {
            return id;
        }
        String name = state.name() + " of line " + state.line();
        problems.note(state.line(), "state without a name is called " + Problems.quote(name) + "; give it an id");
        return name;
    }

    private static List<String> actions(XmlNode node, String block) {
        List<String> actions = new ArrayList<>();
        node.children(block).forEach(child -> actions.addAll(ScxmlActions.in(child)));
        return actions;
    }
}
