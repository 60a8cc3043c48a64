package org.evoloop.xmi.scxml;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.evoloop.statechart.Place;
import org.evoloop.xmi.dialect.Problems;
import org.evoloop.xmi.dialect.XmlNode;
import org.jspecify.annotations.Nullable;

/** The states of a document, by id and by where they stand. */
final class ScxmlTree {
    private static final Set<String> VERTICES = Set.of("state", "parallel", "final", "history");

    private final ScxmlDocument document;
    private final Problems problems;
    private final Map<String, XmlNode> byId = new HashMap<>();
    private final Map<XmlNode, String> keys = new HashMap<>();
    /** Of a vertex that stands in the root: null. */
    private final Map<XmlNode, @Nullable XmlNode> parents = new HashMap<>();

    private int madeUp;

    ScxmlTree(ScxmlDocument document, Problems problems) {
        this.document = document;
        this.problems = problems;
        vertices(null).forEach(vertex -> add(vertex, null));
    }

    private void add(XmlNode vertex, @Nullable XmlNode parent) {
        String id = vertex.attribute("id").strip();
        keys.put(vertex, id.isEmpty() ? madeUpKey() : id);
        parents.put(vertex, parent);
        if (id.isEmpty() && (vertex.name().equals("state") || vertex.name().equals("parallel"))) {
            problems.add(vertex.line(), vertex.name() + " without a name; give it an id");
        }
        XmlNode namesake = id.isEmpty() ? null : byId.putIfAbsent(id, vertex);
        if (namesake != null) {
            problems.add(
                    vertex.line(),
                    vertex.name() + " " + Problems.quote(id) + " has the id of the " + namesake.name() + " in line "
                            + namesake.line() + "; give each an id of its own");
        }
        vertices(vertex).forEach(inner -> add(inner, vertex));
    }

    /** A key that no id can be. */
    String madeUpKey() {
        return "#" + ++madeUp;
    }

    ScxmlDocument document() {
        return document;
    }

    String key(XmlNode vertex) {
        return String.valueOf(keys.get(vertex));
    }

    @Nullable
    XmlNode find(String id) {
        return byId.get(id);
    }

    /** The state in which this vertex stands; null for the root. */
    @Nullable
    XmlNode parent(XmlNode vertex) {
        return parents.get(vertex);
    }

    /** All elements in a state, or in the root for null. */
    List<XmlNode> children(@Nullable XmlNode container) {
        return container == null ? document.children() : container.children();
    }

    /** Vertices directly in a state, or in the root for null. */
    List<XmlNode> vertices(@Nullable XmlNode container) {
        return children(container).stream()
                .filter(child -> VERTICES.contains(child.name()))
                .toList();
    }

    static boolean isParallel(@Nullable XmlNode vertex) {
        return vertex != null && vertex.name().equals("parallel");
    }

    /** Whether something is in this state. */
    boolean isComposite(XmlNode vertex) {
        return isParallel(vertex) || !vertices(vertex).isEmpty();
    }

    /** Whether SCXML raises an event when this state is done. */
    boolean canBeDone(XmlNode vertex) {
        return vertex.name().equals("parallel")
                || vertices(vertex).stream().anyMatch(inner -> inner.name().equals("final"));
    }

    /** Whether a state can be done while this one is active, be it the same. */
    boolean mayHearOfDone(XmlNode state) {
        return keys.keySet().stream()
                .anyMatch(other -> canBeDone(other)
                        && (other == state
                                || isInside(other, state)
                                || (isInside(state, other) && isParallel(other))
                                || isParallel(commonContainer(List.of(other, state)))));
    }

    /** Whether the vertex stands in the container at any depth; everything but the root stands in the root. */
    boolean isInside(@Nullable XmlNode vertex, @Nullable XmlNode container) {
        XmlNode outer = vertex;
        while (outer != null) {
            outer = parents.get(outer);
            if (outer == container) {
                return true;
            }
        }
        return false;
    }

    /** The innermost element in which all of these stand; null for the root. */
    @Nullable
    XmlNode commonContainer(List<XmlNode> vertices) {
        XmlNode container = parents.get(vertices.get(0));
        while (container != null) {
            XmlNode candidate = container;
            if (vertices.stream().allMatch(vertex -> isInside(vertex, candidate))) {
                break;
            }
            container = parents.get(container);
        }
        return container;
    }

    /** The vertices with these ids; an unknown one is a problem. */
    List<XmlNode> targets(String ids, int line, String what) {
        List<XmlNode> found = new ArrayList<>();
        for (String id : ids.strip().split("\\s+", -1)) {
            XmlNode target = id.isEmpty() ? null : byId.get(id);
            if (target != null) {
                found.add(target);
            } else if (!id.isEmpty()) {
                problems.add(line, what + " leads to " + Problems.quote(id) + ", which is no state; correct the id");
            }
        }
        return found;
    }

    static Place place(XmlNode node) {
        return new Place(node.attribute("id").strip(), node.line());
    }
}
