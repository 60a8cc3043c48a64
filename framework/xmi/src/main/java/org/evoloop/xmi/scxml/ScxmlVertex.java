package org.evoloop.xmi.scxml;

import java.util.ArrayList;
import java.util.List;
import org.evoloop.statechart.Place;
import org.evoloop.xmi.dialect.XmlNode;
import org.jspecify.annotations.Nullable;

/**
 * A {@code state}, {@code parallel}, {@code final} or {@code history}, and where it stands. What is in it is sorted
 * once: vertices, transitions and the rest.
 *
 * <p>A vertex equals itself alone. Written by {@link ScxmlTree} alone.
 */
final class ScxmlVertex {
    private final XmlNode node;
    private final String id;
    private final String key;
    private final @Nullable ScxmlVertex parent;
    private final List<ScxmlVertex> inner = new ArrayList<>();
    private final List<XmlNode> transitions = new ArrayList<>();
    private final List<XmlNode> rest = new ArrayList<>();

    /**
     * @param key its id, or one made up for it if it has none
     * @param parent null in the root
     */
    ScxmlVertex(XmlNode node, String id, String key, @Nullable ScxmlVertex parent) {
        this.node = node;
        this.id = id;
        this.key = key;
        this.parent = parent;
    }

    void addInner(ScxmlVertex vertex) {
        inner.add(vertex);
    }

    /** What stands directly in it and is no vertex. */
    void add(XmlNode child) {
        (child.name().equals("transition") ? transitions : rest).add(child);
    }

    /** The element. */
    XmlNode node() {
        return node;
    }

    /** Stripped; empty if it has none. */
    String id() {
        return id;
    }

    /** Unique in its document. */
    String key() {
        return key;
    }

    int line() {
        return node.line();
    }

    Place place() {
        return new Place(id, node.line());
    }

    /** The vertex in which it stands; null for the root. */
    @Nullable
    ScxmlVertex parent() {
        return parent;
    }

    /** Vertices directly in it. */
    List<ScxmlVertex> inner() {
        return inner;
    }

    /** Transitions directly in it. */
    List<XmlNode> transitions() {
        return transitions;
    }

    /** Elements of this name directly in it that are neither vertices nor transitions. */
    List<XmlNode> elements(String name) {
        if (rest.isEmpty()) {
            return List.of();
        }
        return rest.stream().filter(child -> child.name().equals(name)).toList();
    }

    /** Elements directly in it that are neither vertices nor transitions. */
    List<XmlNode> rest() {
        return rest;
    }

    boolean isState() {
        return node.name().equals("state");
    }

    boolean isParallel() {
        return node.name().equals("parallel");
    }

    boolean isFinal() {
        return node.name().equals("final");
    }

    boolean isHistory() {
        return node.name().equals("history");
    }

    /** Whether something is in it. */
    boolean isComposite() {
        return isParallel() || !inner.isEmpty();
    }

    /** Whether SCXML raises an event when it is done. */
    boolean canBeDone() {
        return isParallel() || inner.stream().anyMatch(ScxmlVertex::isFinal);
    }

    /** Whether it stands in the container at any depth; everything stands in the root, which null stands for. */
    boolean isInside(@Nullable ScxmlVertex container) {
        ScxmlVertex outer = this;
        while (outer != null) {
            outer = outer.parent;
            if (outer == container) {
                return true;
            }
        }
        return false;
    }

    /** For messages. */
    String label() {
        return ScxmlVocabulary.label(node);
    }
}
