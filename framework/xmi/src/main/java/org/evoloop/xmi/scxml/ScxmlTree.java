package org.evoloop.xmi.scxml;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.StringTokenizer;
import java.util.function.Supplier;
import org.evoloop.xmi.dialect.Problems;
import org.evoloop.xmi.dialect.XmlNode;
import org.jspecify.annotations.Nullable;

/** The vertices of a document, by id and as a tree. */
final class ScxmlTree {
    private final ScxmlDocument document;
    private final Problems problems;
    private final Map<String, ScxmlVertex> byId = new HashMap<>();
    private final List<ScxmlVertex> all = new ArrayList<>();
    private final List<ScxmlVertex> outermost = new ArrayList<>();
    private final Set<String> descriptors = new HashSet<>();

    private int madeUp;

    ScxmlTree(ScxmlDocument document, Problems problems) {
        this.document = document;
        this.problems = problems;
        for (XmlNode child : document.children()) {
            if (isVertex(child)) {
                outermost.add(vertex(child, null));
            } else {
                collectDescriptors(child);
            }
        }
        all.forEach(this::enter);
    }

    /** Makes a vertex known by its id. */
    private void enter(ScxmlVertex vertex) {
        // A copy, so that all ids are close together: a hundred thousand look-ups would be slow if each key lay
        // somewhere among all that was read from the file.
        String id = new String(vertex.node().attribute("id").strip().toCharArray());
        vertex.name(id, id.isEmpty() ? madeUpKey() : id);
        ScxmlVertex namesake = id.isEmpty() ? null : byId.putIfAbsent(id, vertex);
        if (namesake != null) {
            problems.add(
                    vertex.line(),
                    vertex.node().name() + " " + Problems.quote(id) + " has the id of the "
                            + namesake.node().name() + " in line " + namesake.line() + "; give each an id of its own");
        }
    }

    private static boolean isVertex(XmlNode node) {
        return switch (node.name()) {
            case "state", "parallel", "final", "history" -> true;
            default -> false;
        };
    }

    private ScxmlVertex vertex(XmlNode node, @Nullable ScxmlVertex parent) {
        ScxmlVertex vertex = new ScxmlVertex(node, parent);
        all.add(vertex);
        for (XmlNode child : node.children()) {
            if (isVertex(child)) {
                vertex.addInner(vertex(child, vertex));
            } else {
                vertex.add(child);
                collectDescriptors(child);
            }
        }
        return vertex;
    }

    private void collectDescriptors(XmlNode node) {
        switch (node.name()) {
            case "transition", "send", "raise" -> descriptors.add(node.attribute("event"));
            default -> {}
        }
        // Most elements have no children; this avoids an iterator for each.
        if (!node.children().isEmpty()) {
            node.children().forEach(this::collectDescriptors);
        }
    }

    /** The different event attributes, as written; there are far fewer of these than transitions. */
    Set<String> descriptors() {
        return descriptors;
    }

    /** A new key that no id can equal. */
    String madeUpKey() {
        return "#" + ++madeUp;
    }

    ScxmlDocument document() {
        return document;
    }

    @Nullable
    ScxmlVertex find(String id) {
        return byId.get(id);
    }

    /** The elements directly in a vertex that are neither vertices nor transitions; for null, all in the root. */
    List<XmlNode> rest(@Nullable ScxmlVertex container) {
        return container == null ? document.children() : container.rest();
    }

    /** The vertices directly in a state, or in the root for null. */
    List<ScxmlVertex> vertices(@Nullable ScxmlVertex container) {
        return container == null ? outermost : container.inner();
    }

    static boolean isParallel(@Nullable ScxmlVertex container) {
        return container != null && container.isParallel();
    }

    /** The innermost vertex that contains all of these; null for the root. */
    static @Nullable ScxmlVertex commonContainer(List<ScxmlVertex> some) {
        ScxmlVertex container = some.get(0).parent();
        while (container != null) {
            ScxmlVertex candidate = container;
            if (some.stream().allMatch(vertex -> vertex.isInside(candidate))) {
                break;
            }
            container = container.parent();
        }
        return container;
    }

    /**
     * The vertices with these ids; reports unknown ids.
     *
     * @param ids separated by white space
     */
    List<ScxmlVertex> targets(String ids, int line, Supplier<String> what) {
        // There is rarely more than one; then nothing is split.
        ScxmlVertex only = isOneWord(ids) ? byId.get(ids) : null;
        if (only != null) {
            return List.of(only);
        }
        StringTokenizer words = new StringTokenizer(ids);
        List<ScxmlVertex> found = new ArrayList<>();
        while (words.hasMoreTokens()) {
            String id = words.nextToken();
            ScxmlVertex target = byId.get(id);
            if (target != null) {
                found.add(target);
            } else {
                problems.add(
                        line,
                        what.get() + " leads to " + Problems.quote(id) + ", which is not a state; correct the id");
            }
        }
        return found;
    }

    private static boolean isOneWord(String ids) {
        for (int i = 0; i < ids.length(); i++) {
            if (ids.charAt(i) <= ' ') {
                return false;
            }
        }
        return true;
    }
}
