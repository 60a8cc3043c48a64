package org.evoloop.xmi.scxml;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.evoloop.statechart.Place;
import org.evoloop.xmi.dialect.XmlNode;
import org.jspecify.annotations.Nullable;

/**
 * A {@code state}, {@code parallel}, {@code final} or {@code history}, with its position in the tree. Its contents are
 * sorted once into vertices, transitions and the rest.
 *
 * <p>A vertex equals only itself. Written only by {@link ScxmlTree}.
 */
final class ScxmlVertex {
    private final XmlNode node;
    private String id = "";
    private String key = "";
    private final @Nullable ScxmlVertex parent;
    private final boolean understood;
    private final List<XmlNode> transitions = new ArrayList<>();
    // Most vertices have nothing else in them. Unlike List.of(), this empty list makes no iterators.
    private List<ScxmlVertex> inner = Collections.emptyList();
    private List<XmlNode> rest = Collections.emptyList();

    /** @param parent null in the root */
    ScxmlVertex(XmlNode node, @Nullable ScxmlVertex parent) {
        this.node = node;
        this.parent = parent;
        this.understood = ScxmlVocabulary.understands(node);
    }

    /** @param ownKey its id, or a generated one */
    void name(String ownId, String ownKey) {
        id = ownId;
        key = ownKey;
    }

    void addInner(ScxmlVertex vertex) {
        inner = inner.isEmpty() ? new ArrayList<>() : inner;
        inner.add(vertex);
    }

    /** Adds a child that is not a vertex. */
    void add(XmlNode child) {
        if (child.name().equals("transition")) {
            transitions.add(child);
        } else {
            rest = rest.isEmpty() ? new ArrayList<>() : rest;
            rest.add(child);
        }
    }

    /** The element. */
    XmlNode node() {
        return node;
    }

    /** The id, stripped; empty if it has none. */
    String id() {
        return id;
    }

    /** Unique in its document. */
    String key() {
        return key;
    }

    /** Whether everything in its element is read. */
    boolean isUnderstood() {
        return understood;
    }

    int line() {
        return node.line();
    }

    Place place() {
        return new Place(id, node.line());
    }

    /** The vertex that contains it; null for the root. */
    @Nullable
    ScxmlVertex parent() {
        return parent;
    }

    /** The vertices directly in it. */
    List<ScxmlVertex> inner() {
        return inner;
    }

    /** The transitions directly in it. */
    List<XmlNode> transitions() {
        return transitions;
    }

    /** The elements with this name directly in it that are neither vertices nor transitions. */
    List<XmlNode> elements(String name) {
        if (rest.isEmpty()) {
            return List.of();
        }
        return rest.stream().filter(child -> child.name().equals(name)).toList();
    }

    /** The elements directly in it that are neither vertices nor transitions. */
    List<XmlNode> rest() {
        return rest;
    }

    boolean isState() {
        return node.name().equals("state");
    }

    boolean isParallel() {
        return node.name().equals("parallel");
    }

    /** Drafts of SCXML had an attribute for it. */
    boolean isFinal() {
        return node.name().equals("final") || node.attribute("final").equals("true");
    }

    boolean isHistory() {
        return node.name().equals("history");
    }

    /** Whether it contains vertices. */
    boolean isComposite() {
        return isParallel() || !inner.isEmpty();
    }

    /** Whether SCXML raises an event when it completes. */
    boolean canBeDone() {
        return isParallel()
                ? inner.stream().anyMatch(vertex -> !vertex.isHistory())
                : inner.stream().anyMatch(ScxmlVertex::isFinal);
    }

    /** Whether it is inside the container at any depth; everything is inside the root, which is null. */
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
