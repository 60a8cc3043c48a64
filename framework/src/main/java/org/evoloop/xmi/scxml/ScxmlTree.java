package org.evoloop.xmi.scxml;

import static java.util.Objects.requireNonNull;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.StringTokenizer;
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
    private final Map<XmlNode, Placed> vertices = new HashMap<>();
    private final List<XmlNode> outermost;

    private int madeUp;

    /** @param parent of a vertex that stands in the root: null */
    private record Placed(String key, @Nullable XmlNode parent, List<XmlNode> inner) {}

    ScxmlTree(ScxmlDocument document, Problems problems) {
        this.document = document;
        this.problems = problems;
        this.outermost = verticesAmong(document.children());
        outermost.forEach(vertex -> add(vertex, null));
    }

    private static List<XmlNode> verticesAmong(List<XmlNode> nodes) {
        List<XmlNode> found = new ArrayList<>();
        for (XmlNode node : nodes) {
            if (VERTICES.contains(node.name())) {
                found.add(node);
            }
        }
        return found;
    }

    private void add(XmlNode vertex, @Nullable XmlNode parent) {
        String id = vertex.attribute("id").strip();
        List<XmlNode> inner = verticesAmong(vertex.children());
        vertices.put(vertex, new Placed(id.isEmpty() ? madeUpKey() : id, parent, inner));
        XmlNode namesake = id.isEmpty() ? null : byId.putIfAbsent(id, vertex);
        if (namesake != null) {
            problems.add(
                    vertex.line(),
                    vertex.name() + " " + Problems.quote(id) + " has the id of the " + namesake.name() + " in line "
                            + namesake.line() + "; give each an id of its own");
        }
        inner.forEach(child -> add(child, vertex));
    }

    /** A key that no id can be. */
    String madeUpKey() {
        return "#" + ++madeUp;
    }

    ScxmlDocument document() {
        return document;
    }

    String key(XmlNode vertex) {
        return placed(vertex).key();
    }

    @Nullable
    XmlNode find(String id) {
        return byId.get(id);
    }

    /** The state in which this vertex stands; null for the root. */
    @Nullable
    XmlNode parent(XmlNode vertex) {
        return placed(vertex).parent();
    }

    private Placed placed(XmlNode vertex) {
        return requireNonNull(vertices.get(vertex));
    }

    /** All elements in a state, or in the root for null. */
    List<XmlNode> children(@Nullable XmlNode container) {
        return container == null ? document.children() : container.children();
    }

    /** Vertices directly in a state, or in the root for null. */
    List<XmlNode> vertices(@Nullable XmlNode container) {
        return container == null ? outermost : placed(container).inner();
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
        return vertices.keySet().stream()
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
            outer = parent(outer);
            if (outer == container) {
                return true;
            }
        }
        return false;
    }

    /** The innermost element in which all of these stand; null for the root. */
    @Nullable
    XmlNode commonContainer(List<XmlNode> some) {
        XmlNode container = parent(some.get(0));
        while (container != null) {
            XmlNode candidate = container;
            if (some.stream().allMatch(vertex -> isInside(vertex, candidate))) {
                break;
            }
            container = parent(container);
        }
        return container;
    }

    /** The vertices with these ids; an unknown one is a problem. */
    List<XmlNode> targets(String ids, int line, String what) {
        List<XmlNode> found = new ArrayList<>(1);
        for (String id : words(ids)) {
            XmlNode target = byId.get(id);
            if (target != null) {
                found.add(target);
            } else {
                problems.add(line, what + " leads to " + Problems.quote(id) + ", which is no state; correct the id");
            }
        }
        return found;
    }

    /** The words of an attribute that holds several, with white space between them. */
    static List<String> words(String attribute) {
        StringTokenizer tokens = new StringTokenizer(attribute.strip());
        List<String> words = new ArrayList<>(1);
        while (tokens.hasMoreTokens()) {
            words.add(tokens.nextToken());
        }
        return words;
    }

    static Place place(XmlNode node) {
        return new Place(node.attribute("id").strip(), node.line());
    }
}
