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
        List<String> scripts = new ArrayList<>();
        beginning(null, beginning, scripts);
        beginning.addAll(scripts);
        if (tree.vertices(null).isEmpty()) {
            problems.add(document.line(), "scxml has no state; write one");
        }
        arcs.readAll(null);
        Region region = region(null, "", new Place("", document.line()), beginning);
        return new Statechart(title, region.place(), List.of(region), List.of(), Statechart.Semantics.SCXML);
    }

    /** Collects what runs before the first state is entered: the initial values of all data, and then the scripts. */
    private void beginning(@Nullable ScxmlVertex container, List<String> values, List<String> scripts) {
        for (XmlNode child : tree.rest(container)) {
            if (child.name().equals("datamodel")) {
                ScxmlVocabulary.check(child, problems);
                values.addAll(ScxmlActions.data(child));
                if (container != null && tree.document().attribute("binding").equals("late")) {
                    problems.add(child.line(), "late binding of data is not supported; use binding=\"early\"");
                }
            } else if (child.name().equals("script")) {
                scripts.add(ScxmlActions.text(child));
            }
        }
        tree.vertices(container).forEach(vertex -> beginning(vertex, values, scripts));
    }

    /** The region with the contents of a state, or of the root for null. */
    private Region region(@Nullable ScxmlVertex container, String name, Place place, List<String> effects) {
        String region = arcs.regionIn(container);
        List<Vertex> vertices = new ArrayList<>();
        if (!tree.vertices(container).isEmpty()) {
            vertices.add(initial(container, region, place, effects));
        }
        for (ScxmlVertex vertex : tree.vertices(container)) {
            vertex(vertex, vertices);
        }
        vertices.addAll(arcs.forksIn(region));
        return new Region(name, place, vertices, arcs.in(region));
    }

    private Vertex initial(@Nullable ScxmlVertex container, String region, Place place, List<String> effects) {
        String key = tree.madeUpKey();
        List<XmlNode> elements = tree.rest(container).stream()
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
                    "initial of " + (container == null ? "scxml" : container.label())
                            + " is not one transition; write one");
        } else {
            List<ScxmlVertex> targets =
                    ids.isBlank() ? firstState(container) : tree.targets(ids, place.line(), () -> "initial");
            arcs.lead(key, region, targets, "", () -> "initial", effects, place);
        }
        return new Pseudostate(key, "", place, Kind.INITIAL);
    }

    private String attribute(@Nullable ScxmlVertex container, String name) {
        return container == null
                ? tree.document().attribute(name)
                : container.node().attribute(name);
    }

    private List<ScxmlVertex> firstState(@Nullable ScxmlVertex container) {
        return tree.vertices(container).stream()
                .filter(vertex -> !vertex.isHistory())
                .limit(1)
                .toList();
    }

    private void vertex(ScxmlVertex vertex, List<Vertex> vertices) {
        if (!vertex.isUnderstood()) {
            ScxmlVocabulary.check(vertex.node(), problems);
        }
        if (vertex.isHistory()) {
            vertices.add(new Pseudostate(vertex.key(), shown(vertex), vertex.place(), kind(vertex)));
        } else if (vertex.isFinal()) {
            vertices.add(end(vertex));
        } else {
            vertices.add(state(vertex, regions(vertex)));
        }
    }

    private FinalState end(ScxmlVertex vertex) {
        if (vertex.isComposite() || !vertex.transitions().isEmpty()) {
            problems.add(vertex.line(), vertex.label() + " is final but goes on; let it end here");
        }
        List<String> entry = Stream.concat(
                        actions(vertex, "onentry").stream(),
                        vertex.elements("donedata").stream().map(ScxmlActions::text))
                .toList();
        return new FinalState(vertex.key(), shown(vertex), vertex.place(), entry, actions(vertex, "onexit"));
    }

    private List<Region> regions(ScxmlVertex state) {
        if (!state.isParallel()) {
            return state.inner().isEmpty() ? List.of() : List.of(region(state, "", state.place(), List.of()));
        }
        List<Region> regions = new ArrayList<>();
        for (ScxmlVertex child : state.inner()) {
            if (child.isHistory()) {
                continue;
            }
            String initial = tree.madeUpKey();
            List<Vertex> vertices = new ArrayList<>();
            vertices.add(new Pseudostate(initial, "", child.place(), Kind.INITIAL));
            vertex(child, vertices);
            vertices.addAll(arcs.forksIn(arcs.region(child)));
            histories(state, child, vertices);
            List<Arc> inRegion = new ArrayList<>();
            inRegion.add(new Arc(child.place(), initial, child.key(), List.of(), "", List.of(), Arc.Kind.EXTERNAL));
            inRegion.addAll(arcs.in(arcs.region(child)));
            regions.add(new Region(name(child), child.place(), vertices, inRegion));
        }
        return regions;
    }

    /** A parallel state's history becomes one history in each of its regions. */
    private void histories(ScxmlVertex parallel, ScxmlVertex child, List<Vertex> vertices) {
        for (ScxmlVertex vertex : parallel.inner()) {
            if (vertex.isHistory()) {
                vertices.add(
                        new Pseudostate(arcs.historyKey(vertex, child), vertex.id(), vertex.place(), kind(vertex)));
            }
        }
    }

    private static Kind kind(ScxmlVertex history) {
        return history.node().attribute("type").equals("deep") ? Kind.DEEP_HISTORY : Kind.SHALLOW_HISTORY;
    }

    private ChartState state(ScxmlVertex vertex, List<Region> regions) {
        noteUnnamed(vertex);
        return new ChartState(
                vertex.key(),
                name(vertex),
                vertex.place(),
                actions(vertex, "onentry"),
                actions(vertex, "onexit"),
                invoked(vertex),
                arcs.internal(vertex),
                List.of(),
                regions,
                List.of(),
                ScxmlOwn.use(vertex.node()));
    }

    private static List<String> invoked(ScxmlVertex vertex) {
        List<XmlNode> elements = vertex.elements("invoke");
        return elements.isEmpty()
                ? List.of()
                : elements.stream().map(ScxmlActions::text).toList();
    }

    /** The state's name, or its id. If it has none, which SCXML allows, its name is made from its line. */
    private static String name(ScxmlVertex state) {
        String shown = shown(state);
        return shown.isEmpty() ? state.node().name() + " of line " + state.line() : shown;
    }

    /** The id, or the name that {@link ScxmlWriter} gives what cannot have its name as an id. */
    private static String shown(ScxmlVertex vertex) {
        String name = vertex.node().attribute(XmlNode.EVOLOOP + ScxmlOwn.NAME);
        return name.isEmpty() ? vertex.id() : name;
    }

    private void noteUnnamed(ScxmlVertex state) {
        if (state.id().isEmpty()) {
            problems.note(
                    state.line(), "state without a name is called " + Problems.quote(name(state)) + "; give it an id");
        }
    }

    private static List<String> actions(ScxmlVertex vertex, String block) {
        if (vertex.rest().isEmpty()) {
            return List.of();
        }
        List<String> actions = new ArrayList<>();
        vertex.elements(block).forEach(child -> actions.addAll(ScxmlActions.in(child)));
        return actions;
    }
}
